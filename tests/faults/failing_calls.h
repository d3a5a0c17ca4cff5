#pragma once

#include <atomic>
#include <cstdint>

namespace lacuna {

/// What the library `failing_calls` counts, in a file that the processes of a program share. Loaded into the program by
/// LD_PRELOAD, it lets one call fail (LACUNA_FAIL_AT, from 1 on), or this one and all after it
/// (LACUNA_FAIL_LASTING=yes). LACUNA_FAIL_WHAT is what counts:
///
///   calls        those of the system on files in LACUNA_FAIL_FOLDER, in which the program works: open, read, write,
///                sync, truncate, map, rename, link, unlink and close
///   allocations  of memory, in processes that have made such a call, from then on
///
/// A failed write finds the disk full; other calls find it broken.
struct FailureCount {
  std::atomic<std::uint64_t> calls;     ///< that count
  std::atomic<std::uint64_t> failures;  ///< of them
};

}  // namespace lacuna
