#pragma once

#include <exception>
#include <string>

namespace lacuna {

/// Raises this process's limits on open files and on stacks to the program's needs, as far as the system allows. Throws
/// `Error` that says which limit is too small, and how to raise it.
void prepare_limits();

/// The message for a failed allocation. Allocates only the text.
std::string no_memory_sentence();
/// Where memory is limited, why a process may have crashed without an exception; else empty.
std::string crash_for_want_of_memory();
/// The text of an exception; for one without a useful text, as where memory or threads are used up, a sentence.
std::string failure_sentence(const std::exception& error);
/// Prints `no_memory_sentence`, and that the database is safe, on standard error by system calls alone, because streams
/// and texts take memory.
void tell_no_memory() noexcept;

/// "too many files are open ..." where no more can be opened; else empty.
std::string used_up_descriptors();

/// Why processes that this one started and waited for were killed if they used up their processor time (`ulimit -t`);
/// else empty.
std::string used_up_processor_time();

}  // namespace lacuna
