#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// Iterates over the lines of a text, which must live longer.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// The next line without its end (\n or \r\n), and its number, which counts from 1. False at the end.
  bool next(std::string_view& line, int& number);
  /// Whether the line just read ended with the file instead of a line end.
  bool at_cut_end() const { return cut_; }

 private:
  std::string_view rest_;
  int number_ = 0;
  bool cut_ = false;
};

/// Splits lines into cells. Quoted cells lose their quotes, and doubled quotes in them become one.
/// A delimiter of ' ' means runs of spaces and tabs; lines may start and end with them.
/// The views are valid until the next split, and as long as the text is.
class CellSplitter {
 public:
  explicit CellSplitter(char delimiter) : delimiter_(delimiter) {}

  enum class Result { split, open_quote };
  Result split(std::string_view line);
  const std::vector<std::string_view>& cells() const { return cells_; }
  /// Adds empty cells to those of a line.
  void fill_up(std::size_t count) { cells_.resize(count); }

 private:
  void split_at_runs(std::string_view line);
  Result split_with_quotes(std::string_view line);

  char delimiter_;
  std::vector<std::string_view> cells_;
  std::string unquoted_;
};

}  // namespace lacuna
