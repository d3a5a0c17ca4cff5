#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace lacuna {

/// Settings of this thread's processor for floating-point numbers: rounding, numbers near zero, trapped errors. Without
/// status flags, such as for an inexact result.
inline std::uint32_t floating_point_control() noexcept {
#if defined(__x86_64__)
  constexpr std::uint32_t kWithoutFlags = 0xFFC0;
  return _mm_getcsr() & kWithoutFlags;
#elif defined(__aarch64__)
  std::uint64_t control = 0;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  return static_cast<std::uint32_t>(control);
#else
#error "read this processor's floating-point control here"
#endif
}

/// The settings of this program; until they are set, those at the program's start.
#if defined(__x86_64__)
inline constinit std::uint32_t usual_floating_point_control = 0x1F80;
#else
inline constinit std::uint32_t usual_floating_point_control = 0;
#endif

/// Takes a few instructions: for use after each call of a plugin.
inline bool floating_point_is_usual() noexcept { return floating_point_control() == usual_floating_point_control; }

}  // namespace lacuna
