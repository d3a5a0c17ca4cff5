#pragma once

#include "support/sanitizers.h"

/// A program that calls `allocations` replaces malloc: ODE allocates with malloc and realloc, C++ with operator new,
/// which ends in malloc, so that all are counted. Sanitizers have an allocator of their own, which stays.
namespace lacuna {

inline constexpr bool kCountsAllocations = LACUNA_WATCHED == 0;
/// Why a test that counts them is skipped otherwise.
inline constexpr const char* kOwnAllocator = "the sanitizer has its own allocator";

/// Of the whole process so far; 0 under a sanitizer.
long allocations();

}  // namespace lacuna
