#pragma once

namespace lacuna {

/// Whether this system's kernel can restrict a process to certain files (Landlock, Linux 5.13 and later).
bool has_file_sandbox();

/// Where this process works for an agent (`files_are_limited`), the kernel from now on restricts it, its threads and
/// its children to the allowed folders and the system files that programs read: nothing else is read, written or
/// started, and, from Linux 6.7 on, no TCP connection is made. So a plugin or a link cannot get around the checks of
/// names. Without Landlock there are only these checks. Throws `Error` where the kernel has it and refuses.
void enter_file_sandbox();

}  // namespace lacuna
