#include "app/terminal/text_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace lacuna {
namespace {

constexpr std::size_t kContext = 2;

std::vector<std::string_view> lines_of(const std::string& text) {
  std::vector<std::string_view> lines;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return lines;
}

}  // namespace

std::string text_diff(const std::string& before, const std::string& after) {
  const std::vector<std::string_view> old_lines = lines_of(before), new_lines = lines_of(after);
  const std::size_t shorter = std::min(old_lines.size(), new_lines.size());
  std::size_t head = 0, tail = 0;
  while (head < shorter && old_lines[head] == new_lines[head]) ++head;
  while (tail < shorter - head && old_lines[old_lines.size() - 1 - tail] == new_lines[new_lines.size() - 1 - tail])
    ++tail;
  if (head == old_lines.size() && head == new_lines.size()) return "";

  std::string text;
  const auto show = [&](char mark, const std::vector<std::string_view>& lines, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) text += fmt::format("{:>5} {} {}\n", i + 1, mark, lines[i]);
  };
  show(' ', old_lines, head - std::min(head, kContext), head);
  show('-', old_lines, head, old_lines.size() - tail);
  show('+', new_lines, head, new_lines.size() - tail);
  show(' ', new_lines, new_lines.size() - tail, new_lines.size() - tail + std::min(tail, kContext));
  return text;
}

}  // namespace lacuna
