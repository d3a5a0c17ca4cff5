#include "report/pages/page_json.h"

#include "report/pages/base64.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

using PageJson = nlohmann::json;

constexpr std::int64_t kLargestExact = std::int64_t{1} << 53;  ///< a page's numbers are double

PageJson json_of(double number, bool typed) {
  if (std::isfinite(number)) return number;
  return typed ? PageJson(number > 0.0 ? "Infinity" : "-Infinity") : PageJson(nullptr);
}

PageJson json_of(const PageCell& cell, bool typed) {
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) {
    const bool exact = *integer <= kLargestExact && *integer >= -kLargestExact;
    return exact ? PageJson(*integer) : PageJson(std::to_string(*integer));
  }
  if (const auto* number = std::get_if<double>(&cell)) return json_of(*number, typed);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* bytes = std::get_if<std::vector<std::byte>>(&cell)) return {{"base64", base64(*bytes)}};
  if (const auto* blob = std::get_if<Blob>(&cell)) return {{"bytes", blob->bytes}};
  return nullptr;
}

}  // namespace

PageCell page_cell_of(const PageJson& value) {
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return std::monostate{};
}

std::string page_json(const PageTable& table, bool typed, std::size_t most_bytes) {
  std::string text = "{\"columns\":" + page_json(PageJson(table.columns)) + ",\"rows\":[";
  for (const std::vector<PageCell>& row : table.rows) {
    if (text.back() != '[') text += ',';
    text += '[';
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ',';
      text += page_json(json_of(row[i], typed));
      if (text.size() > most_bytes)
        throw Error(
            fmt::format("the answer is longer than {} MB; select fewer rows or columns", most_bytes / 1'000'000));
    }
    text += ']';
  }
  return text + "],\"cut\":" + (table.cut ? "true}" : "false}");
}

std::string page_json(const PageJson& value) { return value.dump(-1, ' ', false, PageJson::error_handler_t::replace); }

}  // namespace lacuna
