#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace lacuna {

/// How this thread's processor computes with floating-point numbers: rounding, what becomes of numbers near zero, which
/// errors are trapped. What it has met so far, such as an inexact result, is none of it.
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

/// What it is in this program; before anything has set it, what a program begins with.
#if defined(__x86_64__)
inline constinit std::uint32_t usual_floating_point_control = 0x1F80;
#else
inline constinit std::uint32_t usual_floating_point_control = 0;
#endif

/// A few instructions: for after each call of a plugin.
inline bool floating_point_is_usual() noexcept { return floating_point_control() == usual_floating_point_control; }

}  // namespace lacuna
