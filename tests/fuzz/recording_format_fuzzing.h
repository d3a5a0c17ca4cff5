#pragma once

#include "fuzzing.h"
#include "support/test_folder.h"

#include <lacuna/recording_format.h>

#include <cstddef>
#include <vector>

namespace lacuna::fuzz {

inline void require_sentences(const std::vector<RecordingSentence>& sentences) {
  for (const RecordingSentence& one : sentences) require(!one.text.empty(), "a sentence has words");
}

inline std::vector<TableQuery> everything(const RecordingContents& found) {
  std::vector<TableQuery> queries;
  for (const RecordedTable& table : found.tables) {
    require(!table.columns.empty(), "a table has columns");
    queries.push_back({table.name, {}});
    for (const RecordedColumn& column : table.columns) {
      require(!column.name.empty(), "a column has a name");
      queries.back().columns.push_back(column.name);
    }
  }
  return queries;
}

inline void require_whole(const ReadRows& read, const std::vector<TableQuery>& queries) {
  require(read.tables.size() == queries.size(), "there are rows of each table");
  for (std::size_t t = 0; t < queries.size(); ++t) {
    const RecordedRows& rows = read.tables[t];
    require(rows.columns.size() == queries[t].columns.size(), "there is each column");
    require(rows.origins.size() == rows.columns.size(), "a column has an origin");
    require(rows.lines.empty() || rows.lines.size() == rows.columns.front().size(), "a row has a line");
    for (const std::vector<double>& column : rows.columns)
      require(column.size() == rows.columns.front().size() && column.size() <= queries[t].most_rows,
              "columns are equally long");
  }
}

/// Whatever a file holds, it has tables whose rows are whole, all of them and the first few, or it is refused.
template <class Contents, class Rows>
void read_bytes_as(const std::string& name, const std::string& bytes, Contents contents_of, Rows rows_of) {
  static const TestFolder folder;
  const std::string file = folder.write(name, bytes).string();
  const RecordingContents found = contents_of(file);
  require_sentences(found.remarks);
  require_sentences(found.problems);
  if (!found.problems.empty()) return;
  std::vector<TableQuery> queries = everything(found);
  for (const std::size_t most : {queries.empty() ? 0 : queries.front().most_rows, std::size_t{2}}) {
    for (TableQuery& query : queries) query.most_rows = most;
    const ReadRows read = rows_of(file, queries);
    for (const auto* sentences : {&read.remarks, &read.doubts, &read.problems}) require_sentences(*sentences);
    if (read.problems.empty()) require_whole(read, queries);
  }
}

}  // namespace lacuna::fuzz
