#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace lacuna {

/// All descendants of `process` that are still connected to it.
std::vector<pid_t> descendants_of(pid_t process);

/// All processes of this user that started with this variable in their environment, whatever group, session or parent
/// they have since: descendants inherit their environment. Without this process.
std::vector<pid_t> processes_with(const std::string& variable);

/// In the environment of a process that must outlive the command that started it, such as a browser.
inline constexpr const char* kOutlives = "LACUNA_OUTLIVES=1";

/// Whether this process has children, including ones that ended and were not waited for.
bool has_children();

/// The first words of the command that started a process, safe to print.
std::string command_of(pid_t process);

/// The descendants of this process, without those with `kOutlives`.
std::vector<pid_t> processes_to_end();

/// Ends all descendants of this process without `kOutlives`, including those that lost their parent if this process is
/// their subreaper: asks them first (SIGTERM), and ends them (SIGKILL) if they still run after `grace` s. Processes of
/// another user are left.
void end_descendants(double grace);

}  // namespace lacuna
