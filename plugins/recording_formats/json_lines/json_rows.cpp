#include "json_rows.h"

#include "line_file.h"

#include <lacuna/json_tree.h>
#include <lacuna/row_columns.h>

#include <algorithm>
#include <set>

namespace lacuna::json_lines {
namespace {

constexpr int kLinesForColumns = 10000;
constexpr std::size_t kMostProblems = 100;  ///< invalid lines, after which a file is not JSON Lines
constexpr std::size_t kMostNamed = 8;

/// Passes on one tree per line.
class Rows {
 public:
  explicit Rows(const std::string& path) : file_(path) {}

  bool next(ValueTree& tree) {
    std::string_view line;
    while (problems_.size() < kMostProblems && file_.next(line)) {
      if (line.find_first_not_of(" \t") == line.npos) continue;
      if (read(line, tree)) return true;
    }
    if (!file_.fault().empty()) problems_.push_back({0, file_.fault()});
    return false;
  }
  int line() const { return file_.number(); }
  std::vector<RecordingSentence> problems() { return std::move(problems_); }
  std::vector<RecordingSentence> doubts() { return std::move(doubts_); }

 private:
  bool read(std::string_view line, ValueTree& tree) {
    if (line.find('\0') != line.npos)
      return refuse("has zero bytes, as after a power loss of the logger; delete the file from this line on");
    const std::string fault = parser_.read(line, tree);
    if (!fault.empty() && file_.at_cut_end()) {
      doubts_.push_back({line_number(), "the file ends in the middle of its last line, which is left out"});
      return false;
    }
    if (!fault.empty()) return refuse("is not JSON: " + fault + "; each line must contain one complete object");
    const ValueTree::Kind kind = tree.nodes().front().kind;
    if (kind == ValueTree::Kind::object || kind == ValueTree::Kind::list) return true;
    return refuse("is a single value; each line must contain one complete object");
  }

  bool refuse(const std::string& reason) {
    problems_.push_back({line_number(), "the line " + reason});
    return false;
  }
  int line_number() const { return file_.number(); }

  LineFile file_;
  JsonTree parser_;
  std::vector<RecordingSentence> problems_, doubts_;
};

/// Names some of the values that a table cannot hold.
class Oddities {
 public:
  void add(std::string_view path) {
    if (paths_.size() < kMostNamed) paths_.emplace(path);
  }
  void tell(const std::string& what, std::vector<RecordingSentence>& remarks) const {
    std::string text;
    for (const std::string& path : paths_) text += (text.empty() ? "`" : ", `") + path + "`";
    if (!text.empty()) remarks.push_back({0, what + ", not read as columns: " + text});
  }

 private:
  std::set<std::string> paths_;
};

}  // namespace

RecordingContents contents_of(const std::string& path) {
  Rows rows(path);
  ValueTree tree;
  NumberPaths paths;
  ColumnNames columns;
  Oddities long_lists;
  RecordingContents contents;
  bool is_whole = true;
  while (rows.line() < kLinesForColumns && rows.next(tree))
    paths.walk(
        tree, [&](std::string_view name, LongNumber) { is_whole = columns.add(name) && is_whole; },
        [&](std::string_view name, std::size_t elements) {
          if (elements > 0) long_lists.add(name);
        });
  contents.problems = rows.problems();
  if (columns.size() > 0) contents.tables.push_back({"", columns.columns(), ""});
  long_lists.tell("lists of more than " + std::to_string(NumberPaths::kMostElements) + " elements", contents.remarks);
  if (!is_whole)
    contents.remarks.push_back({0, "has more than " + std::to_string(ColumnNames::kMostColumns) +
                                       " paths with numbers; the others are not read as columns"});
  return contents;
}

ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries) {
  std::vector<RowColumns> columns;
  for (const TableQuery& query : queries) columns.emplace_back(query);
  Rows rows(path);
  ValueTree tree;
  NumberPaths paths;
  const auto all_full = [&] {
    return std::all_of(columns.begin(), columns.end(), [](const RowColumns& one) { return one.is_full(); });
  };
  while (!all_full() && rows.next(tree)) {
    for (RowColumns& one : columns) one.begin_row(rows.line());
    paths.walk(
        tree,
        [&](std::string_view name, LongNumber number) {
          for (RowColumns& one : columns) one.put(name, number);
        },
        [](std::string_view, std::size_t) {});
  }
  ReadRows read;
  for (RowColumns& one : columns) read.tables.push_back(one.take());
  read.problems = rows.problems();
  read.doubts = rows.doubts();
  return read;
}

}  // namespace lacuna::json_lines
