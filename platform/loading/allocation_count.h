#pragma once

namespace lacuna {

/// Starts counting the allocations of shared libraries, without the program's own. This changes the process for good:
/// use it only in a process that tries plugins and then ends.
void count_allocations();

/// Of this thread since then.
long allocations_of_this_thread();

}  // namespace lacuna
