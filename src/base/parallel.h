#pragma once

#include <functional>

namespace orbs {

/// Calls work(index) once for each index in [0, count) on `threads` threads (0: all cores). Any thread may
/// take any index, so results must depend on the index alone. After an exception the remaining indices are
/// left out, all threads stop, and the first exception is rethrown in the caller.
void for_each_index(int count, int threads, const std::function<void(int)>& work);

}  // namespace orbs
