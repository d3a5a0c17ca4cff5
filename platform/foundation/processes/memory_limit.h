#pragma once

#include <cstdint>

namespace lacuna {

/// Bytes that a program may use of this machine, or of the container around it, leaving some to others: nine tenths.
std::uint64_t usable_memory();

/// From now on an allocation that takes this process, or one that it starts, beyond `bytes` fails (`std::bad_alloc`). A
/// smaller existing limit stays. A build with a sanitizer, which needs address space, has no limit.
void limit_memory(std::uint64_t bytes);

/// The same of the stack of the first thread.
void limit_stack(std::uint64_t bytes);

}  // namespace lacuna
