#include "measurement/file_sample.h"

#include "measurement/csv_lines.h"
#include "measurement/date_stamp.h"
#include "measurement/measured_text.h"
#include "measurement/number_cell.h"

#include <algorithm>
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

/// A cell as a number; of a column of dates the time since its first one, s.
class SampledColumn {
 public:
  NumberCell read(std::string_view text, bool decimal_comma) {
    const NumberCell cell = read_number(text, decimal_comma);
    if (cell.kind != CellKind::text) return cell;
    const std::optional<DateStamp> date = read_date_stamp(trimmed(text));
    if (!date) return cell;
    if (!first_) first_ = date->seconds;
    return {CellKind::number, static_cast<double>(date->seconds - *first_) + date->fraction};
  }

 private:
  std::optional<std::int64_t> first_;  ///< s since 1970
};

}  // namespace

int FileSample::find(const std::string& name) const {
  const auto place = std::find(format.names.begin(), format.names.end(), name);
  return place == format.names.end() ? -1 : static_cast<int>(place - format.names.begin());
}

FileSample sample_file(const std::filesystem::path& path) {
  FileReport report(path.string());
  FileSample sample;
  sample.path = path;
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
  return sample;
}

}  // namespace lacuna
