#pragma once

#include <cstdint>

namespace lacuna {

/// Bytes that programs of this machine, or of the container around it, may use together.
std::uint64_t memory_of_machine();

/// From now on an allocation that takes this process, or one that it begins, past `bytes` fails, as memory that is used
/// up does (`std::bad_alloc`). A limit that is there already and is smaller stays. A build with a sanitizer, which needs
/// address space of its own, has no limit.
void limit_memory(std::uint64_t bytes);

/// The same of each thread's stack, where it begins or grows.
void limit_stack(std::uint64_t bytes);

}  // namespace lacuna
