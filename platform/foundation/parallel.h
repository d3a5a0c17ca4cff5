#pragma once

#include <cstddef>
#include <functional>

namespace lacuna {

/// Default number of threads: one per processor.
int default_threads();

/// Calls `work(index, worker)` for every index below `count`, on up to `threads` threads. `worker` is below `threads`
/// and never used by two calls at a time. Results must not depend on `worker` or on the order. The exception of the
/// smallest failing index is thrown after all have ended.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t index, int worker)>& work);

}  // namespace lacuna
