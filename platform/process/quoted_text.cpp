#include "process/quoted_text.h"

#include <vector>

namespace lacuna {
namespace {

constexpr std::size_t kQuoted = 80, kLine = 200;

/// Control characters would move a terminal's cursor, and what is no UTF-8 would make no valid report.
std::string printable(std::string_view text, std::size_t most) {
  std::string result;
  for (const char c : text.substr(0, most)) result += c >= ' ' && c <= '~' ? c : '.';
  return text.size() > most ? result + "..." : result;
}

}  // namespace

std::string quoted_text(std::string_view text) { return "\"" + printable(text, kQuoted) + "\""; }

std::string last_lines(std::string_view text, std::size_t most) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < most) {
    const std::size_t last = text.find_last_not_of("\r\n\t ");
    if (last == std::string_view::npos) break;
    text = text.substr(0, last + 1);
    const std::size_t begin = text.rfind('\n');
    lines.push_back(begin == std::string_view::npos ? text : text.substr(begin + 1));
    text = begin == std::string_view::npos ? std::string_view() : text.substr(0, begin);
  }
  std::string result;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line)
    result += (result.empty() ? "  " : "\n  ") + printable(*line, kLine);
  return result;
}

}  // namespace lacuna
