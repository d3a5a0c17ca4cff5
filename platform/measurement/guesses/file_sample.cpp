#include "measurement/guesses/file_sample.h"

#include "measurement/clocks/clock_wraps.h"
#include "measurement/csv/csv_lines.h"
#include "measurement/csv/csv_runs.h"
#include "measurement/cells/date_stamp.h"
#include "measurement/csv/measured_text.h"
#include "measurement/cells/number_cell.h"
#include "measurement/guesses/recording_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr std::size_t kRows = 20000;

void throw_problems(FileReport& report) {
  ProblemList problems;
  std::vector<ReadingNote> notes;
  report.move_to(problems, notes);
  problems.throw_if_any();
}

/// A cell as a number; for a column of dates or times of day the time since its first one, s.
class SampledColumn {
 public:
  NumberCell read(std::string_view text, bool decimal_comma) {
    const NumberCell cell = read_number(text, decimal_comma);
    if (cell.kind != CellKind::text) return cell;
    std::optional<DateStamp> date = read_date_stamp(trimmed(text));
    if (const auto time = date ? std::nullopt : read_clock_time(trimmed(text))) date = time->since;
    if (!date) return cell;
    if (!first_) first_ = date->seconds;
    return {CellKind::number, static_cast<double>(date->seconds - *first_) + date->fraction};
  }

 private:
  std::optional<std::int64_t> first_;  ///< s since 1970
};

/// Whole seconds and their fractions in two columns are one time (clock_wraps.h), assigned to the first; the second
/// gets none.
void join_split_times(FileSample& sample) {
  for (std::size_t c = 0; c < sample.columns.size(); ++c) {
    const auto fraction = fraction_beside(sample.format.names[c], sample.format.names);
    const int other = fraction ? sample.find(fraction->name) : -1;
    if (other < 0) continue;
    std::vector<double>&seconds = sample.columns[c], &parts = sample.columns[static_cast<std::size_t>(other)];
    bool split = !seconds.empty();
    for (std::size_t i = 0; i < seconds.size(); ++i) {
      const double part = parts[i] * fraction->unit;
      split = split && seconds[i] == std::round(seconds[i]) && part >= 0.0 && part < 1.0;
    }
    if (!split) continue;
    for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] += parts[i] * fraction->unit;
    std::fill(parts.begin(), parts.end(), std::numeric_limits<double>::quiet_NaN());
    sample.numeric_share[static_cast<std::size_t>(other)] = 0.0;
  }
}

/// Rows after the end of a run, where only longer runs have values, are left out.
void drop_rows_behind_end(FileSample& sample) {
  std::size_t rows = 0;
  for (const std::vector<double>& column : sample.columns)
    for (std::size_t i = column.size(); i > rows; --i)
      if (std::isfinite(column[i - 1])) rows = i;
  for (std::vector<double>& column : sample.columns) column.resize(std::min(rows, column.size()));
}

FileSample sample_of_run(const FileSample& sample, const std::string& run) {
  FileSample own;
  own.path = sample.path;
  own.run = run;
  own.format = sample.format;
  own.format.names.clear();
  own.format.units.clear();
  for (std::size_t c = 0; c < sample.columns.size(); ++c) {
    const std::string& name = sample.format.names[c];
    if (is_of_other_run(name, run)) continue;
    own.format.names.push_back(name_in_run(name, run));
    if (c < sample.format.units.size()) own.format.units.push_back(sample.format.units[c]);
    own.columns.push_back(sample.columns[c]);
    own.numeric_share.push_back(sample.numeric_share[c]);
  }
  drop_rows_behind_end(own);
  return own;
}

}  // namespace

std::string FileSample::label() const { return path.filename().string() + (run.empty() ? "" : "[" + run + "]"); }

std::vector<FileSample> samples_of_runs(std::vector<FileSample> samples) {
  std::vector<std::string> all;
  for (const FileSample& sample : samples) {
    const std::vector<std::string> runs = runs_in(sample.format.names);
    if (runs.empty()) return samples;
    all.insert(all.end(), runs.begin(), runs.end());
  }
  if (std::ranges::all_of(all, [&](const std::string& run) { return run == all.front(); })) return samples;
  std::vector<FileSample> of_runs;
  for (const FileSample& sample : samples)
    for (const std::string& run : runs_in(sample.format.names)) of_runs.push_back(sample_of_run(sample, run));
  return of_runs;
}

int FileSample::find(const std::string& name) const {
  const auto place = std::find(format.names.begin(), format.names.end(), name);
  return place == format.names.end() ? -1 : static_cast<int>(place - format.names.begin());
}

FileSample sample_file(const std::filesystem::path& path, const RecordingFormats* formats) {
  FileReport report(path.string());
  FileSample sample;
  sample.path = path;
  if (formats && formats->reads(path)) {
    sample = sample_recording(path, *formats, report);
    throw_problems(report);
    return sample;
  }
  const std::string text = read_measured_text(path, report);
  if (!report.has_problems()) sample.format = find_csv_format(text, {}, report);
  throw_problems(report);

  const std::size_t count = sample.format.names.size();
  sample.columns.resize(count);
  std::vector<std::size_t> numbers(count), texts(count);
  std::vector<SampledColumn> columns(count);
  LineReader reader(text);
  CellSplitter splitter(sample.format.delimiter);
  std::string_view line;
  int number = 0;
  while (count > 0 && sample.columns[0].size() < kRows && reader.next(line, number)) {
    if (number < sample.format.first_line || is_skipped_line(line)) continue;
    if (splitter.split(line) != CellSplitter::Result::split || splitter.cells().size() < count) continue;
    for (std::size_t c = 0; c < count; ++c) {
      const NumberCell cell = columns[c].read(splitter.cells()[c], sample.format.decimal_comma);
      sample.columns[c].push_back(cell.kind == CellKind::number ? cell.value
                                                                : std::numeric_limits<double>::quiet_NaN());
      numbers[c] += cell.kind == CellKind::number ? 1 : 0;
      texts[c] += cell.kind == CellKind::text ? 1 : 0;
    }
  }
  for (std::size_t c = 0; c < count; ++c)
    sample.numeric_share.push_back(static_cast<double>(numbers[c]) /
                                   static_cast<double>(std::max<std::size_t>(numbers[c] + texts[c], 1)));
  join_split_times(sample);
  return sample;
}

}  // namespace lacuna
