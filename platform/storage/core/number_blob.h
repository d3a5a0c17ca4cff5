#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

/// Numbers as float64 bytes, little-endian: every bit is kept, that of −0.0 and of a NaN, too.
namespace lacuna {

inline std::span<const std::byte> number_bytes(std::span<const double> numbers) { return std::as_bytes(numbers); }

inline std::vector<double> numbers_in(std::span<const std::byte> bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

}  // namespace lacuna
