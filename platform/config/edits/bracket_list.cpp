#include "config/edits/bracket_list.h"

#include "config/toml/toml_scanner.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

bool closes(char c) { return c == ']' || c == '}'; }

/// One past the value that begins at `at`: strings and nested brackets count as one.
std::size_t skip_value(std::string_view text, std::size_t at) {
  std::size_t depth = 0;
  std::size_t end = at;  // one past the last character that belongs to the value
  while (at < text.size()) {
    const char c = text[at];
    if (depth == 0 && (c == ',' || closes(c))) break;
    if (c == '#') {
      at = skip_comment(text, at);
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if (closes(c)) --depth;
    at = c == '"' || c == '\'' ? skip_string(text, at) : at + 1;
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') end = at;
  }
  return end;
}

}  // namespace

BracketList::BracketList(std::string_view text, std::size_t at) : text_(text) {
  if (at >= text.size() || text[at] != '[') throw Error("there is no list here");
  inside_.begin = at + 1;
  at = skip_space_and_comments(text, at + 1);
  while (at < text.size() && text[at] != ']') {
    Item item{{at, skip_value(text, at)}, std::nullopt};
    if (item.span.end == at) throw Error("an item of the list is empty");
    at = skip_space_and_comments(text, item.span.end);
    if (at < text.size() && text[at] == ',') {
      item.comma = at;
      at = skip_space_and_comments(text, at + 1);
    }
    items_.push_back(item);
  }
  if (at >= text.size()) throw Error("the list has no closing bracket");
  inside_.end = at;
}

bool BracketList::begins_its_line(const Item& item) const {
  const std::size_t begin = line_begin(text_, item.span.begin);
  return begin > inside_.begin && skip_blanks(text_, begin) == item.span.begin;
}

bool BracketList::ends_its_line(const Item& item) const {
  std::size_t at = skip_blanks(text_, item.span.end);
  if (item.comma && *item.comma != at) return false;
  if (item.comma) at = skip_blanks(text_, at + 1);
  if (at < text_.size() && text_[at] == '#') at = skip_comment(text_, at);
  return at == line_end(text_, at);
}

std::string BracketList::with_first(const std::string& item) const {
  const std::string new_line = line_end_of(text_);
  const std::string margin(indentation(text_, inside_.begin - 1));
  const std::string entry = new_line + margin + "  " + item + ",";
  const std::string_view content = text_.substr(inside_.begin, inside_.end - inside_.begin);
  const bool is_bare = content.find_first_not_of(" \t") == std::string_view::npos;
  if (is_bare) return edited(text_, {{inside_, entry + new_line + margin}});
  const std::size_t last_line = line_begin(text_, inside_.end);  // a comment ends with its line, so `]` begins its own
  const std::size_t at = last_line - (text_.substr(0, last_line).ends_with("\r\n") ? 2 : 1);
  return edited(text_, {{{at, at}, entry}});
}

std::string BracketList::with(const std::string& item) const {
  if (items_.empty()) return with_first(item);
  const Item& last = items_.back();
  const std::size_t end = last.span.end;
  if (!begins_its_line(last)) return edited(text_, {{{end, end}, ", " + item}});
  std::string entry = line_end_of(text_);
  entry += indentation(text_, last.span.begin);
  entry += item;
  if (!ends_its_line(last)) return edited(text_, {{{end, end}, "," + entry}});
  const std::size_t line = line_end(text_, last.comma.value_or(end));
  if (last.comma) return edited(text_, {{{line, line}, entry + ","}});
  if (line == end) return edited(text_, {{{end, end}, "," + entry}});
  return edited(text_, {{{end, end}, ","}, {{line, line}, entry}});
}

std::string BracketList::without(std::size_t index) const {
  const Item& item = items_.at(index);
  const bool is_last = index + 1 == items_.size();
  const bool has_own_lines = begins_its_line(item) && ends_its_line(item);
  std::vector<TextEdit> edits;
  if (is_last && index > 0 && !(has_own_lines && item.comma)) {  // the comma before it would be left over
    const std::size_t comma = *items_[index - 1].comma;
    edits.push_back({{comma, comma + 1}, ""});
  }
  Span span{item.span.begin, item.comma ? *item.comma + 1 : item.span.end};
  if (has_own_lines) {
    span.begin = line_begin(text_, span.begin);
    span.end = after_line_end(text_, line_end(text_, span.end));
  } else if (is_last) {
    const std::size_t first = index > 0 ? *items_[index - 1].comma + 1 : inside_.begin;
    const bool only_space =
        text_.substr(first, span.begin - first).find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (only_space) span.begin = first;
    if (index > 0) span.end = item.span.end;
  } else {
    span.end = skip_blanks(text_, span.end);
  }
  const std::string_view before = text_.substr(inside_.begin, span.begin - inside_.begin);
  const std::string_view after = text_.substr(span.end, inside_.end - span.end);
  const bool nothing_left = items_.size() == 1 && before.find_first_not_of(" \t\r\n") == std::string_view::npos &&
                            after.find_first_not_of(" \t\r\n") == std::string_view::npos;
  if (nothing_left) return edited(text_, {{inside_, ""}});
  edits.push_back({span, ""});
  return edited(text_, edits);
}

}  // namespace lacuna
