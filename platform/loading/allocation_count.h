#pragma once

namespace lacuna {

/// From now on what shared libraries allocate is counted, the program's own code apart. It changes the process for
/// good: only for one that tries plugins and then ends.
void count_allocations();

/// By this thread since then.
long allocations_of_this_thread();

}  // namespace lacuna
