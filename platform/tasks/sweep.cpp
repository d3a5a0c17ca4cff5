#include "tasks/sweep.h"

#include <lacuna/error.h>

#include <fmt/format.h>

namespace lacuna {
namespace {

/// Where the next part ends: at `separator`, or at the end of the text.
std::size_t end_of_part(const std::string& text, std::size_t begin, char separator) {
  int depth = 0;
  char quote = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
      continue;
    }
    if (c == '"' || c == '\'') quote = c;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (c == separator && depth == 0) return i;
  }
  return text.size();
}

}  // namespace

SweptKey read_sweep(const std::string& text) {
  const std::size_t equals = end_of_part(text, 0, '=');
  if (equals == 0 || equals + 1 >= text.size())
    throw Error("--sweep " + text + ": write KEY=VALUE,VALUE, as in --sweep engine.step=0.001,0.002");
  SweptKey key{text.substr(0, equals), {}};
  for (std::size_t begin = equals + 1; begin <= text.size();) {
    const std::size_t end = end_of_part(text, begin, ',');
    if (end == begin) throw Error("--sweep " + text + ": a value is empty");
    key.second.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return key;
}

std::vector<std::vector<std::string>> sweep_points(const std::vector<SweptKey>& keys) {
  std::vector<std::vector<std::string>> points = {{}};
  for (const auto& [key, values] : keys) {
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& point : points)
      for (const std::string& value : values) {
        longer.push_back(point);
        longer.back().push_back(fmt::format("{}={}", key, value));
      }
    points = std::move(longer);
  }
  return points;
}

}  // namespace lacuna
