#include "command_line/whole_number.h"

#include <fmt/format.h>

#include <charconv>

namespace lacuna {

CLI::Validator whole_number(std::uint64_t lower, std::uint64_t upper) {
  const std::string range = fmt::format("a whole number from {} to {}", lower, upper);
  return CLI::Validator(
      [lower, upper, range](const std::string& text) {
        std::uint64_t number = 0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        const bool fits = error == std::errc() && stop == end && number >= lower && number <= upper;
        return fits ? std::string() : "must be " + range + ", but is \"" + text + "\"";
      },
      "");
}

}  // namespace lacuna
