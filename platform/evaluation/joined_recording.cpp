#include "evaluation/joined_recording.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lacuna {
namespace {

template <class List>
auto find_named(List& list, const std::string& name) {
  return std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
}

void add_table(RecordedTable&& table, std::vector<RecordedTable>& tables) {
  const auto known = find_named(tables, table.name);
  if (known == tables.end()) {
    tables.push_back(std::move(table));
    return;
  }
  for (RecordedColumn& column : table.columns)
    if (find_named(known->columns, column.name) == known->columns.end()) known->columns.push_back(std::move(column));
}

/// Each sentence once, with the names of the parts that it holds for unless it holds for all.
std::vector<RecordingSentence> joined(const std::vector<std::string>& names,
                                      const std::vector<RecordingContents>& parts,
                                      std::vector<RecordingSentence> RecordingContents::*kind) {
  struct Said {
    std::string text, names;
    std::size_t count = 0;
  };
  std::vector<Said> all;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const RecordingSentence& one : parts[p].*kind) {
      auto said = std::find_if(all.begin(), all.end(), [&](const Said& other) { return other.text == one.text; });
      if (said == all.end()) said = all.insert(all.end(), {one.text, "", 0});
      said->names += (said->count++ == 0 ? "" : ", ") + names[p];
    }
  std::vector<RecordingSentence> sentences;
  for (const Said& said : all)
    sentences.push_back({0, said.count == parts.size() ? said.text : said.names + ": " + said.text});
  return sentences;
}

}  // namespace

RecordingContents joined_contents(const std::vector<std::string>& names, std::vector<RecordingContents> parts) {
  RecordingContents whole;
  whole.remarks = joined(names, parts, &RecordingContents::remarks);
  whole.problems = joined(names, parts, &RecordingContents::problems);
  for (RecordingContents& part : parts)
    for (RecordedTable& table : part.tables) add_table(std::move(table), whole.tables);
  return whole;
}

std::size_t row_count(const RecordedRows& rows) { return rows.columns.empty() ? 0 : rows.columns.front().size(); }

TableQuery query_of_part(const TableQuery& query, const RecordingContents& part, std::size_t before) {
  TableQuery own{query.table, {}, query.most_rows - std::min(query.most_rows, before)};
  const auto table = find_named(part.tables, query.table);
  if (table == part.tables.end() || own.most_rows == 0) return own;
  for (const std::string& column : query.columns)
    if (find_named(table->columns, column) != table->columns.end()) own.columns.push_back(column);
  return own;
}

void append_rows(const TableQuery& query, const TableQuery& of_part, const RecordedRows& part, RecordedRows& all) {
  const std::size_t before = row_count(all), more = row_count(part);
  all.columns.resize(query.columns.size());
  all.origins.resize(query.columns.size(), 0.0);
  for (std::size_t c = 0; c < query.columns.size(); ++c) {
    std::vector<double>& column = all.columns[c];
    column.resize(before + more, std::numeric_limits<double>::quiet_NaN());
    const auto place = std::find(of_part.columns.begin(), of_part.columns.end(), query.columns[c]);
    if (place == of_part.columns.end() || more == 0) continue;
    const auto own = static_cast<std::size_t>(place - of_part.columns.begin());
    if (std::none_of(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(before),
                     [](double value) { return value == value; }))
      all.origins[c] = part.origins[own];  // nothing was counted from another
    const double shift = part.origins[own] - all.origins[c];
    for (std::size_t row = 0; row < more; ++row) column[before + row] = part.columns[own][row] + shift;
  }
}

}  // namespace lacuna
