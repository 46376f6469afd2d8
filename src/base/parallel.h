#pragma once

#include <functional>

namespace orbs {

/// Calls work(index) once for each index in [0, count) on `threads` threads (0: all cores). Which thread
/// takes which index is not fixed: results must depend on the index alone. The first exception is rethrown in
/// the caller after all threads have stopped; the remaining indices are then left out.
void for_each_index(int count, int threads, const std::function<void(int)>& work);

}  // namespace orbs
