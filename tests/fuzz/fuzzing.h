#pragma once

#include <lacuna/error.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace lacuna::fuzz {

/// Ends the process where a promise is broken, which the fuzzer takes for a crash and keeps the input.
inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Whether `work` is done. A refusal has a sentence; any other exception ends the process.
inline bool is_done(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const Error& refusal) {
    require(*refusal.what() != '\0', "a refusal has a sentence");
    return false;
  }
}

}  // namespace lacuna::fuzz
