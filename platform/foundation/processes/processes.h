#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace lacuna {

/// All processes that `process` began and that still hang on it, directly or by one between.
std::vector<pid_t> descendants_of(pid_t process);

/// All processes of this user with this variable in the environment that they began with, whatever group, session or
/// parent they took since: what a program has begun inherits its environment. Not this process.
std::vector<pid_t> processes_with(const std::string& variable);

/// In the environment of a process that is to outlive the command which began it, such as a browser.
inline constexpr const char* kOutlives = "LACUNA_OUTLIVES=1";

/// Whether this process has children, be they ones that ended and were not waited for.
bool has_children();

/// The first words of the command that a process was begun with, fit to be printed.
std::string command_of(pid_t process);

/// The processes that hang on this one, but those that `kOutlives`.
std::vector<pid_t> processes_to_end();

/// Ends all processes that hang on this one but those that `kOutlives`, those included that lost their parent where
/// this one is their subreaper: asks them first (SIGTERM), and ends them (SIGKILL) when `grace` s did not suffice. What
/// belongs to another user is left.
void end_descendants(double grace);

}  // namespace lacuna
