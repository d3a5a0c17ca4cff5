#pragma once

#include <exception>
#include <string>

namespace lacuna {

/// Raises this process's limits on open files and on stacks to what the program needs, as far as the system allows it.
/// Throws `Error` that says which limit is too small, and how to raise it.
void prepare_limits();

/// What to say where an allocation failed. Allocates nothing but the text.
std::string no_memory_sentence();
/// Where memory is limited, why a process may have crashed without an exception; else empty.
std::string crash_for_want_of_memory();
/// What an exception says; of one that only names itself, as where memory or threads are used up, a sentence.
std::string failure_sentence(const std::exception& error);
/// The same as `no_memory_sentence`, and that the database is safe, on standard error by the system alone: streams and
/// texts take memory.
void tell_no_memory() noexcept;

/// "too many files are open ..." where no further one can be opened; else empty.
std::string used_up_descriptors();

/// Why processes that this one began and waited for were killed where they used all the processor time that they may
/// (`ulimit -t`); else empty.
std::string used_up_processor_time();

}  // namespace lacuna
