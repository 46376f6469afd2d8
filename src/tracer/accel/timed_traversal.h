#pragma once

#include <chrono>

namespace orbs::tracer {

/// Runs a traversal and adds its duration to the batch. There are three for each bounce of a whole batch, so
/// the clock is read rarely.
template <typename Batch, typename F>
void timed_traversal(Batch& batch, const F& traverse) {
  const auto start = std::chrono::steady_clock::now();
  traverse();
  batch.traversal_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace orbs::tracer
