#pragma once

namespace lacuna {

/// Whether this system's kernel can keep a process to certain files (Landlock, Linux 5.13 and later).
bool has_file_sandbox();

/// Where this process works for an agent (`files_are_limited`), the kernel keeps it, its threads and its children from
/// now on to the allowed folders and what programs read of the system: nothing else is read, written or started, and,
/// from Linux 6.7 on, no connection by TCP is made. So a plugin or a link cannot do what the checks of names would
/// refuse. Without Landlock these checks are all there is. Throws `Error` where the kernel has it and refuses.
void enter_file_sandbox();

}  // namespace lacuna
