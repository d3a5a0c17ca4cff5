#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace lacuna {

/// A number in a sentence: six digits, with a power of ten where it is very large or small ("0.9", "1e+308").
inline std::string number_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace lacuna
