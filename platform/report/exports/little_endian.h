#pragma once

#include <cstdint>
#include <string>

namespace lacuna {

/// Adds the lowest `width` bytes of a number, the lowest first.
inline void append_number(std::string& bytes, std::uint64_t value, int width) {
  for (int i = 0; i < width; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

}  // namespace lacuna
