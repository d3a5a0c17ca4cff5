#pragma once

#include <cstdint>

/// A program that calls these replaces malloc, which operator new and SQLite end in, too.
namespace lacuna {

/// From now on allocations of this process count, and the one with this number (from 1 on) fails; `lasting`: all after
/// it as well. 0: none fails.
void begin_failing_allocations(std::uint64_t at, bool lasting);
/// None fails any more. How many counted.
std::uint64_t end_failing_allocations();

}  // namespace lacuna
