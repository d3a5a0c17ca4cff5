#include "measurement/csv/csv_lines.h"

#include "measurement/cells/number_cell.h"

#include <algorithm>

namespace lacuna {

bool LineReader::next(std::string_view& line, int& number) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  cut_ = end == rest_.npos;
  line = rest_.substr(0, end);
  rest_.remove_prefix(cut_ ? rest_.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  number = ++number_;
  return true;
}

CellSplitter::Result CellSplitter::split(std::string_view line) {
  cells_.clear();
  if (line.find('"') != line.npos) return split_with_quotes(line);
  if (delimiter_ == ' ') {
    split_at_runs(line);
    return Result::split;
  }
  for (std::size_t end = line.find(delimiter_); end != line.npos; end = line.find(delimiter_)) {
    cells_.push_back(line.substr(0, end));
    line.remove_prefix(end + 1);
  }
  cells_.push_back(line);
  return Result::split;
}

void CellSplitter::split_at_runs(std::string_view line) {
  while (!(line = trimmed(line)).empty()) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    cells_.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

CellSplitter::Result CellSplitter::split_with_quotes(std::string_view line) {
  // Unquoting only shortens the text, so the buffer never grows while views into it exist.
  unquoted_.clear();
  unquoted_.reserve(line.size() + 1);
  const auto is_delimiter = [&](char c) { return c == delimiter_ || (delimiter_ == ' ' && c == '\t'); };
  std::size_t start = 0;
  bool quoted = false;
  const auto finish_cell = [&] {
    const std::string_view cell = trimmed(std::string_view(unquoted_).substr(start));
    if (delimiter_ != ' ' || !cell.empty()) cells_.push_back(cell);
    start = unquoted_.size();
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      unquoted_ += line[++i];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && is_delimiter(line[i])) {
      finish_cell();
    } else {
      unquoted_ += line[i];
    }
  }
  finish_cell();
  return quoted ? Result::open_quote : Result::split;
}

}  // namespace lacuna
