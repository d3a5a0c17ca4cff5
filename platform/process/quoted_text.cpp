#include "process/quoted_text.h"

#include <algorithm>
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

std::string plain_text(std::string_view text, std::size_t most) {
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U; };
  std::size_t end = std::min(most, text.size());
  while (end > 0 && end < text.size() && continues(end)) --end;
  std::string result;
  for (std::size_t i = 0; i < end; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F are the control characters of terminals with eight bits
    const bool second_half = byte == 0xC2U && i + 1 < end && static_cast<unsigned char>(text[i + 1]) < 0xA0U;
    result += byte < ' ' || byte == 0x7FU || second_half ? '.' : text[i];
    if (second_half) ++i;
  }
  return end < text.size() ? result + "..." : result;
}

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
