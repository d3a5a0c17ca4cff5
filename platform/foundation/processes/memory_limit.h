#pragma once

#include <cstdint>

namespace lacuna {

/// Bytes that a program may use of this machine, or of the container around it, and leave the others some: nine tenths.
std::uint64_t usable_memory();

/// From now on an allocation that takes this process, or one that it begins, past `bytes` fails, as memory that is used
/// up does (`std::bad_alloc`). A limit that is there already and is smaller stays. A build with a sanitizer, which
/// needs address space of its own, has no limit.
void limit_memory(std::uint64_t bytes);

/// The same of the stack of the first thread.
void limit_stack(std::uint64_t bytes);

}  // namespace lacuna
