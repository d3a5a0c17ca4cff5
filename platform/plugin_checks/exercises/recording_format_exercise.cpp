#include "plugin_checks/exercises/damaged_texts.h"
#include "plugin_checks/exercises/exercises.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <fstream>

namespace lacuna {
namespace {

constexpr std::size_t kFewRows = 3;

std::vector<TableQuery> queries_of(const RecordingContents& contents) {
  std::vector<TableQuery> queries;
  for (const RecordedTable& table : contents.tables) {
    TableQuery& query = queries.emplace_back();
    query.table = table.name;
    for (const RecordedColumn& column : table.columns) query.columns.push_back(column.name);
  }
  return queries;
}

/// The fault of rows that answer queries; empty: none.
std::string rows_fault(const ReadRows& read, const std::vector<TableQuery>& queries) {
  if (!read.problems.empty()) return {};
  if (read.tables.size() != queries.size()) return "read() returns another number of tables than requested";
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const RecordedRows& rows = read.tables[i];
    if (rows.columns.size() != queries[i].columns.size() || rows.origins.size() != rows.columns.size())
      return "read() returns another number of columns, or of origins, than requested";
    for (const std::vector<double>& column : rows.columns)
      if (column.size() != rows.columns.front().size()) return "read() returns columns of different lengths";
    if (!rows.columns.empty() && rows.columns.front().size() > queries[i].most_rows)
      return "read() returns more rows than `most_rows`";
  }
  return {};
}

class RecordingFormatExercise : public Exercise {
 public:
  RecordingFormatExercise(const RecordingFormat& format, const ExerciseInputs& inputs)
      : format_(format), sample_(inputs.sample), scratch_(inputs.scratch) {}

  ParameterDeclarations declared() const override { return {}; }

  void go(const Setting&, Transcript& transcript) const override {
    if (!sample_.empty()) write_down(sample_.string(), transcript);
    const std::vector<std::string> files = damaged_files();
    for (const std::string& file : files) write_down(file, transcript);
  }

  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    if (format_.contents(scratch_ / "there_is_no_such_file").problems.empty())
      broken.emplace_back("a missing file gives no problem; report that it cannot be opened");
    if (sample_.empty()) return broken;
    const RecordingContents contents = format_.contents(sample_.string());
    if (!contents.problems.empty()) return {"the sample has a problem: " + contents.problems.front().text};
    if (contents.tables.empty()) return {"the sample has no table; name the columns of the file"};
    std::vector<TableQuery> queries = queries_of(contents);
    const ReadRows all = format_.read(sample_.string(), queries);
    if (!all.problems.empty()) broken.push_back("the sample has a problem: " + all.problems.front().text);
    if (const std::string fault = rows_fault(all, queries); !fault.empty()) broken.push_back(fault);
    for (TableQuery& query : queries) query.most_rows = kFewRows;
    if (const std::string fault = rows_fault(format_.read(sample_.string(), queries), queries); !fault.empty())
      broken.push_back(fault);
    return broken;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    if (sample_.empty()) return {};
    const std::vector<TableQuery> queries = queries_of(format_.contents(sample_.string()));
    return {repeated_call("read, the sample", true, 1, [&] { format_.read(sample_.string(), queries); })};
  }

  std::string reservation() const override {
    return sample_.empty() ? "no complete file was read; name one of its format with --sample FILE" : "";
  }

 private:
  /// Damaged copies of the sample, with the same names in each process.
  std::vector<std::string> damaged_files() const {
    const std::string whole = sample_.empty() ? "" : text_of_file(sample_);
    const std::vector<std::string> endings = format_.endings();
    const std::string ending = !sample_.empty() ? sample_.extension().string() : endings.empty() ? "" : endings.front();
    std::vector<std::string> files;
    for (const std::string& text : damaged_texts(whole)) {
      files.push_back(scratch_ / fmt::format("damaged_{}{}", files.size(), ending));
      if (!std::filesystem::exists(files.back())) std::ofstream(files.back(), std::ios::binary) << text;
    }
    return files;
  }

  void write_down(const std::string& file, Transcript& transcript) const {
    const RecordingContents contents = format_.contents(file);
    for (const RecordingSentence& problem : contents.problems) transcript.add("contents", problem.line);
    if (!contents.problems.empty()) return;
    const ReadRows read = format_.read(file, queries_of(contents));
    for (const RecordingSentence& problem : read.problems) transcript.add("read", problem.line);
    if (!read.problems.empty()) return;
    for (const RecordedRows& rows : read.tables)
      for (std::size_t i = 0; i < rows.columns.size(); ++i) {
        transcript.add("read", rows.columns[i], Transcript::May::be_anything);
        transcript.add("read", rows.origins[i]);
      }
  }

  const RecordingFormat& format_;
  const std::filesystem::path sample_, scratch_;
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const RecordingFormat& format, const ExerciseInputs& inputs) {
  return std::make_unique<RecordingFormatExercise>(format, inputs);
}

}  // namespace lacuna
