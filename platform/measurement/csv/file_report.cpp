#include "measurement/csv/file_report.h"

#include "measurement/cells/utf8.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {

void FileReport::count_the_rest(Collection& collection) {
  for (const auto& [name, kind] : collection.kinds)
    if (kind.count > kShownOfAKind)
      collection.shown[kind.last_shown].text += fmt::format(" (and {} more like it)", kind.count - kShownOfAKind);
}

void FileReport::move_to(ProblemList& problems, std::vector<ReadingNote>& notes) {
  count_the_rest(problems_);
  count_the_rest(notes_);
  for (Sentence& sentence : problems_.shown) problems.add({file_, sentence.line, 0}, std::move(sentence.text));
  std::stable_sort(notes_.shown.begin(), notes_.shown.end(),
                   [](const Sentence& a, const Sentence& b) { return a.line < b.line; });
  for (Sentence& sentence : notes_.shown)
    notes.push_back({{file_, sentence.line, 0}, std::move(sentence.text), sentence.doubt});
  problems_ = {};
  notes_ = {};
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::size_t end = std::min(text.size(), kLongest);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  const bool readable = is_utf8(text.substr(0, end));
  std::string shown;
  for (const char c : text.substr(0, end)) {
    const auto byte = static_cast<unsigned char>(c);
    shown += byte < 0x20 || byte == 0x7f || (byte > 0x7f && !readable) ? '?' : c;
  }
  return end < text.size() ? shown + "..." : shown;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text += (i == 0 ? "`" : ", `") + excerpt(names[i]) + "`";
  if (names.size() > kMost) text += fmt::format(" and {} more", names.size() - kMost);
  return text;
}

}  // namespace lacuna
