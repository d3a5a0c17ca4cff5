#pragma once

#include "plugins/built_catalog.h"
#include "support/test_folder.h"

#include <lacuna/recording_format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// Recordings as other programs wrote them (tests/plugins/recordings/README.md).
inline std::string recorded_by_others(const std::string& name) {
  return (std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests/plugins/recordings" / name).string();
}

/// A recording format of this build with what it says of files.
class FormatUnderTest {
 public:
  explicit FormatUnderTest(const std::string& name) : format_(built_catalog().get<RecordingFormat>(name)) {}

  RecordingContents contents(const std::string& file) const { return format_.contents(file); }
  ReadRows read(const std::string& file, const std::vector<TableQuery>& queries) const {
    return format_.read(file, queries);
  }

  /// Names of a table's columns, of the only one without a name.
  std::vector<std::string> columns(const std::string& file, const std::string& table = "") const {
    const RecordingContents found = contents(file);
    EXPECT_THAT(texts(found.problems), testing::IsEmpty());
    for (const RecordedTable& one : found.tables)
      if (one.name == table) return names(one);
    ADD_FAILURE() << "no table " << table;
    return {};
  }
  static std::vector<std::string> names(const RecordedTable& table) {
    std::vector<std::string> names;
    for (const RecordedColumn& column : table.columns) names.push_back(column.name);
    return names;
  }

  /// All values of a column.
  std::vector<double> column(const std::string& file, const std::string& name, const std::string& table = "") const {
    const ReadRows read = format_.read(file, {{table, {name}}});
    EXPECT_THAT(texts(read.problems), testing::IsEmpty());
    if (read.tables.size() != 1 || read.tables[0].columns.size() != 1) return {};
    std::vector<double> values = read.tables[0].columns[0];
    const double origin = read.tables[0].origins[0];
    if (origin != 0.0)  // or −0 would become 0
      for (double& value : values) value += origin;
    return values;
  }

  static std::vector<std::string> texts(const std::vector<RecordingSentence>& sentences) {
    std::vector<std::string> texts;
    for (const RecordingSentence& one : sentences)
      texts.push_back(one.line > 0 ? std::to_string(one.line) + ": " + one.text : one.text);
    return texts;
  }
  /// Problems of a file's contents and, where it has none, of its rows.
  std::vector<std::string> problems(const std::string& file) const {
    const RecordingContents found = contents(file);
    return texts(found.problems.empty() ? read_all(file, found).problems : found.problems);
  }
  /// Everything that a file has.
  ReadRows read_all(const std::string& file, const RecordingContents& found) const {
    std::vector<TableQuery> queries;
    for (const RecordedTable& table : found.tables) queries.push_back({table.name, names(table)});
    return format_.read(file, queries);
  }

 private:
  const RecordingFormat& format_;
};

/// Whatever stands in a file, it is read in whole rows or refused with a sentence.
inline bool is_read_or_refused(const FormatUnderTest& format, const std::string& file) {
  const RecordingContents found = format.contents(file);
  if (!found.problems.empty()) return false;
  const ReadRows read = format.read_all(file, found);
  if (!read.problems.empty()) return false;
  EXPECT_EQ(read.tables.size(), found.tables.size());
  for (std::size_t t = 0; t < read.tables.size(); ++t) {
    const RecordedRows& rows = read.tables[t];
    EXPECT_EQ(rows.columns.size(), found.tables[t].columns.size());
    EXPECT_EQ(rows.origins.size(), rows.columns.size());
    for (const std::vector<double>& column : rows.columns) EXPECT_EQ(column.size(), rows.columns.front().size());
  }
  return true;
}

/// Reads a file cut off at every length, and with single bytes changed; how many of these were read.
inline int read_damaged(const FormatUnderTest& format, const std::string& bytes, const std::string& name) {
  const TestFolder folder;
  int read = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length)
    read += is_read_or_refused(format, folder.write(name, bytes.substr(0, length)).string()) ? 1 : 0;
  std::uint32_t dice = 12345;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    dice = dice * 1664525 + 1013904223;
    changed[i] = static_cast<char>(dice >> 24);
    read += is_read_or_refused(format, folder.write(name, changed).string()) ? 1 : 0;
  }
  return read;
}

}  // namespace lacuna
