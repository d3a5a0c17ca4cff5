#include "app/mcp/shortened.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostNumbers = 32, kMostElements = 200;
constexpr std::size_t kMostBytes = 256000;

bool is_of_numbers(const ordered_json& list) {
  return std::all_of(list.begin(), list.end(),
                     [](const ordered_json& one) { return one.is_number() || one.is_null(); });
}

ordered_json with_short_lists(const ordered_json& result);

ordered_json shortened_list(const ordered_json& list) {
  if (list.size() > kMostNumbers && is_of_numbers(list)) return fmt::format("{} numbers, left out", list.size());
  ordered_json kept = ordered_json::array();
  for (std::size_t i = 0; i < std::min(list.size(), kMostElements); ++i) kept.push_back(with_short_lists(list[i]));
  if (list.size() > kMostElements) kept.push_back(fmt::format("{} more, left out", list.size() - kMostElements));
  return kept;
}

ordered_json with_short_lists(const ordered_json& result) {
  if (result.is_array()) return shortened_list(result);
  if (!result.is_object()) return result;
  ordered_json kept = ordered_json::object();
  for (const auto& [name, value] : result.items()) kept[name] = with_short_lists(value);
  return kept;
}

/// Itself, or how long it is.
ordered_json short_or_told(const ordered_json& value) {
  const std::size_t bytes = value.dump(-1, ' ', false, ordered_json::error_handler_t::replace).size();
  if (bytes <= kMostBytes) return value;
  return fmt::format(
      "{} bytes, left out; ask for less, or name a file for the whole result if the tool has the argument json", bytes);
}

}  // namespace

ordered_json shortened(const ordered_json& result) {
  ordered_json kept = with_short_lists(result);
  if (kept.is_object())
    for (auto& [name, value] : kept.items()) value = short_or_told(value);
  return short_or_told(kept);
}

}  // namespace lacuna
