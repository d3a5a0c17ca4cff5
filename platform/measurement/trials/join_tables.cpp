#include "measurement/trials/join_tables.h"

#include "foundation/unit.h"
#include "measurement/clocks/clock_alignment.h"
#include "measurement/clocks/clock_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kSameTime = 1e-6;     ///< of the first file's median interval: closer rows become one row
constexpr double kSlack = 0.5;         ///< s, around a known offset, search range of a skew
constexpr double kLateReading = 0.05;  ///< s: the window in which readings of a start are searched
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// A file with the times of its rows.
struct Part {
  ReadTable read;
  std::string name;
  double seconds_per_unit = 1.0;
  TrialClock clock = {};
  double zero = 0.0;    ///< s, a whole number of its clock from which `start` counts, so that both keep all digits
  double start = 0.0;   ///< s, the rest of its clock at `clock.times` = 0
  double origin = 0.0;  ///< s, the sum of the two
  double offset = 0.0, skew = 0.0;
  std::vector<double> times = {};  ///< s on the first file's clock, since that one's first sample

  bool has(std::size_t column) const { return !read.table.columns[column].empty(); }
  /// A time since the first sample in the file's own time, in which `use` and `mask` are given.
  std::string own_time(double since) const {
    const double time = clock.origin + since;
    return std::abs(time) < 1e6 ? fmt::format("{:.9g} s", time) : fmt::format("{:.6f} s", time);
  }
};

Part part_of(ReadTable read, const std::filesystem::path& path, double seconds_per_unit) {
  Part part{std::move(read), path.filename().string(), seconds_per_unit};
  FileReport& report = part.read.report;
  if (report.has_problems()) return part;
  const CsvTable& table = part.read.table;
  if (table.times.size() < 2) {
    report.problem("no samples", 0, [] { return std::string("has fewer than two samples"); });
    return part;
  }
  part.clock = read_clock(table, rows_by_trial(table).front(), seconds_per_unit, report);
  if (table.dated) part.seconds_per_unit = 1.0;
  part.zero = table.time_origin * part.seconds_per_unit;
  part.start = table.times[part.clock.rows.front()] * part.seconds_per_unit;
  part.origin = part.zero + part.start;
  return part;
}

/// Gaps of a further file are problems where it contains commands; its readings are only missing there.
void check_clock_of(const FurtherFile& file, const RecordingPlan& plan, RecordingSource source, Part& part) {
  if (part.read.report.has_problems()) return;
  source.mask.clear();  // in the first file's time
  if (!file.time_column.empty()) source.time_column = file.time_column;
  if (!file.time_unit.empty()) source.time_unit = file.time_unit;
  bool gives_commands = false;
  for (std::size_t c = plan.sensors.size(); c < part.read.table.columns.size(); ++c)
    gives_commands = gives_commands || part.has(c);
  if (!gives_commands) source.max_gap = std::numeric_limits<double>::infinity();
  check_intervals(part.clock, part.read.table, source, part.read.report);
}

std::vector<Part> parts_of(const RecordingSource& source, const RecordingPlan& plan, const MeasuredFile& file,
                           std::vector<ReadTable> tables) {
  std::vector<Part> parts = {part_of(std::move(tables.front()), file.path, plan.seconds_per_time_unit)};
  for (std::size_t i = 0; i < file.with.size(); ++i) {
    const std::string& unit = file.with[i].time_unit.empty() ? source.time_unit : file.with[i].time_unit;
    parts.push_back(part_of(std::move(tables[i + 1]), file.with[i].path, parse_unit(unit)->to_si));
    if (!file.with[i].table.empty()) parts.back().name += " " + file.with[i].table;
    check_clock_of(file.with[i], plan, source, parts.back());
  }
  return parts;
}

bool has_problems(const std::vector<Part>& parts) {
  return std::any_of(parts.begin(), parts.end(), [](const Part& part) { return part.read.report.has_problems(); });
}

ClockedSignal signal_of(const Part& part, std::size_t column, const PlannedColumn& planned, bool is_reading,
                        bool is_held) {
  ClockedSignal signal{planned.channel.name, planned.channel.unit, is_reading, is_held, {}, {}};
  const std::vector<double>& values = part.read.table.columns[column];
  for (std::size_t i = 0; i < part.clock.rows.size(); ++i) {
    const double value = values[part.clock.rows[i]];
    if (!std::isfinite(value)) continue;
    signal.times.push_back(part.origin + part.clock.times[i]);
    signal.values.push_back(value * planned.factor + planned.mapping->offset);
  }
  if (signal.times.size() < 2) signal.times.clear();
  return signal;
}

std::vector<ClockedSignal> signals_of(const Part& part, const RecordingPlan& plan, Hold hold) {
  std::vector<ClockedSignal> signals;
  const std::vector<const PlannedColumn*> columns = columns_of(plan);
  const std::size_t sensors = plan.sensors.size();
  for (std::size_t c = 0; c < sensors + plan.commands.size(); ++c) {
    if (!part.has(c)) continue;
    const bool is_reading = c < sensors;
    signals.push_back(signal_of(part, c, *columns[c], is_reading, !is_reading && hold == Hold::zero_order));
    if (signals.back().times.empty()) signals.pop_back();
  }
  return signals;
}

/// A number with as many digits as its standard error justifies.
std::string with_error(double value, double error) {
  const int digits = error > 0.0 ? static_cast<int>(std::ceil(1.0 - std::log10(error))) : 9;
  return fmt::format("{:.{}f} ± {:.2g}", value, std::clamp(digits, 0, 12), error);
}

void note_alignment(const FurtherFile& file, const ClockAlignment& found, const Part& first, Part& part) {
  part.read.report.doubt("clock found", 0, [&] {
    std::vector<std::string> numbers;
    if (!file.offset) numbers.push_back("offset = " + with_error(found.offset, found.offset_error) + " s");
    if (!file.skew) numbers.push_back("skew = " + with_error(found.skew, found.skew_error));
    return fmt::format(
        "its clock was compared with that of {} by `{}`: {} (± standard error). The offset includes any delay of a "
        "drive or a sensor",
        first.name, found.by, fmt::join(numbers, ", "));
  });
}

/// Uses the experiment's values for a clock, or estimates them.
void set_clock(const FurtherFile& file, const RecordingPlan& plan, Hold hold, const Part& first, Part& part) {
  part.offset = file.offset.value_or(0.0);
  part.skew = file.skew.value_or(0.0);
  if (file.offset && file.skew) return;
  AlignmentTask task{file.between, part.skew, !file.skew, plan.stop};
  if (file.offset) task.between = {*file.offset - kSlack, *file.offset + kSlack};
  const auto answer = align_clocks(signals_of(first, plan, hold), signals_of(part, plan, hold), task);
  if (const std::string* reason = std::get_if<std::string>(&answer)) {
    part.read.report.problem("clock", 0, [&] {
      return fmt::format(
          "{} of its clock against that of {} was not found: {}. {}", file.offset ? "skew" : "offset", first.name,
          *reason,
          file.offset ? "Write it, as in skew = 2e-5"
                      : "Write it, as in offset = \"0.2 s\", or its range, as in between = [\"-0.5 s\", \"0.5 s\"]");
    });
    return;
  }
  const auto& found = std::get<ClockAlignment>(answer);
  if (!file.offset) part.offset = found.offset;
  part.skew = found.skew;
  note_alignment(file, found, first, part);
}

void take_times(const Part& first, Part& part) {
  for (const double time : part.clock.times)
    part.times.push_back((part.zero - first.zero) + (part.start - first.start) + time + part.offset + part.skew * time);
}

/// Where every command is known, within the range of the first file.
TimeRange span_of(const std::vector<Part>& parts, const RecordingPlan& plan) {
  TimeRange span{parts.front().times.front(), parts.front().times.back()};
  const std::size_t first = plan.sensors.size(), last = columns_of(plan).size() + plan.switches.size();
  for (const Part& part : parts)
    for (std::size_t c = first; c < last; ++c) {
      if (!part.has(c)) continue;
      span.start = std::max(span.start, part.times.front());
      span.end = std::min(span.end, part.times.back());
    }
  return span;
}

void check_overlap(std::vector<Part>& parts) {
  const Part& first = parts.front();
  for (std::size_t p = 1; p < parts.size(); ++p) {
    Part& part = parts[p];
    if (part.times.front() < first.times.back() && part.times.back() > first.times.front()) continue;
    part.read.report.problem("no overlap", 0, [&] {
      return fmt::format(
          "has no time in common with {0}: it covers {1} to {2} on the clock of {0}, which covers {3} to {4}. State "
          "the difference of the clocks, as in offset = \"-3 s\", or write offset = \"auto\"",
          first.name, first.own_time(part.times.front()), first.own_time(part.times.back()),
          first.own_time(first.times.front()), first.own_time(first.times.back()));
    });
  }
}

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The rows of the joined table, each of one or several parts.
struct JoinedRows {
  std::size_t parts = 0;
  std::vector<double> times;          ///< s, as `Part::times`
  std::vector<std::size_t> of_parts;  ///< row by row, the row of each part's table; kNone: that part has none

  std::size_t of(std::size_t row, std::size_t part) const { return of_parts[row * parts + part]; }
};

JoinedRows join_rows(const std::vector<Part>& parts, const TimeRange& span) {
  struct Sample {
    double time;
    std::size_t part, row;
  };
  std::vector<Sample> samples;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t i = 0; i < parts[p].times.size(); ++i)
      if (parts[p].times[i] >= span.start && parts[p].times[i] <= span.end)
        samples.push_back({parts[p].times[i], p, parts[p].clock.rows[i]});
  std::stable_sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.time < b.time; });
  const double same = kSameTime * median_interval(parts.front().times);
  JoinedRows rows{parts.size(), {}, {}};
  for (const Sample& sample : samples) {
    const bool joins = !rows.times.empty() && sample.time - rows.times.back() <= same &&
                       rows.of(rows.times.size() - 1, sample.part) == kNone;
    if (!joins) {
      rows.times.push_back(sample.time);
      rows.of_parts.resize(rows.of_parts.size() + parts.size(), kNone);
    }
    rows.of_parts[(rows.times.size() - 1) * parts.size() + sample.part] = sample.row;
  }
  return rows;
}

CsvTable table_of(const std::vector<Part>& parts, const JoinedRows& rows) {
  const Part& first = parts.front();
  const CsvTable& base = first.read.table;
  CsvTable table;
  table.time_origin = base.time_origin;
  table.dated = base.dated;
  table.first_date = base.first_date;
  for (std::size_t i = 0; i < rows.times.size(); ++i) {
    table.times.push_back(base.times[first.clock.rows.front()] + rows.times[i] / first.seconds_per_unit);
    table.lines.push_back(rows.of(i, 0) == kNone ? 0 : base.lines[rows.of(i, 0)]);
  }
  for (std::size_t c = 0; c < base.columns.size(); ++c) {
    std::vector<double>& column = table.columns.emplace_back(rows.times.size(), kNoValue);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (!parts[p].has(c)) continue;
      for (std::size_t i = 0; i < rows.times.size(); ++i)
        if (rows.of(i, p) != kNone) column[i] = parts[p].read.table.columns[c][rows.of(i, p)];
    }
  }
  return table;
}

/// A column of a file between its known samples.
class ColumnLine {
 public:
  ColumnLine(const Part& part, std::size_t column, Hold hold) : hold_(hold) {
    const std::vector<double>& values = part.read.table.columns[column];
    for (std::size_t i = 0; i < part.times.size(); ++i) {
      if (std::isnan(values[part.clock.rows[i]])) continue;
      times_.push_back(part.times[i]);
      values_.push_back(values[part.clock.rows[i]]);
    }
  }

  /// NaN before the first known sample; after the last, that one.
  double at(double time) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    if (after == times_.begin()) return kNoValue;
    const auto before = static_cast<std::size_t>(after - times_.begin()) - 1;
    if (hold_ == Hold::zero_order || after == times_.end()) return values_[before];
    const double share = (time - times_[before]) / (times_[before + 1] - times_[before]);
    return values_[before] + share * (values_[before + 1] - values_[before]);
  }

 private:
  Hold hold_;
  std::vector<double> times_, values_;
};

/// A command, a reference or a switch is known at every row, whatever file the row comes from, because a piece of the
/// trial may begin there. Signals to be differentiated are interpolated linearly.
void fill_commands_of(const std::vector<Part>& parts, const RecordingPlan& plan, Hold hold, const JoinedRows& rows,
                      CsvTable& table) {
  const std::vector<const PlannedColumn*> planned = columns_of(plan);
  for (std::size_t c = plan.sensors.size(); c < table.columns.size(); ++c) {
    const bool is_switch = c >= planned.size();
    const bool differentiated = !is_switch && planned[c]->mapping->derivative;
    const Hold between = is_switch ? Hold::zero_order : differentiated ? Hold::first_order : hold;
    for (const Part& part : parts) {
      if (!part.has(c)) continue;
      const ColumnLine line(part, c, between);
      for (std::size_t i = 0; i < rows.times.size(); ++i)
        if (std::isnan(table.columns[c][i])) table.columns[c][i] = line.at(rows.times[i]);
    }
  }
}

void note_left_out(const std::vector<Part>& parts, const TimeRange& span, FileReport& report) {
  const Part& first = parts.front();
  if (span.start == first.times.front() && span.end == first.times.back()) return;
  report.note("overlap", 0, [&] {
    return fmt::format("used from {} to {}, where the commands of the other files are known",
                       first.own_time(span.start), first.own_time(span.end));
  });
}

/// A start without readings would count as zero.
void note_late_readings(const std::vector<Part>& parts, const RecordingPlan& plan, const TimeRange& span,
                        FileReport& report) {
  double first_reading = std::numeric_limits<double>::infinity();
  for (const Part& part : parts)
    for (std::size_t c = 0; c < plan.sensors.size(); ++c)
      if (part.has(c)) first_reading = std::min(first_reading, part.times.front());
  if (!(first_reading > span.start + kLateReading)) return;
  report.doubt("late readings", 0, [&] {
    return fmt::format(
        "there are no readings before {0}: begin there, as in use = [[{1:.9g}, {2:.9g}]], or state the initial state",
        parts.front().own_time(first_reading), parts.front().clock.origin + first_reading,
        parts.front().clock.origin + span.end);
  });
}

CsvTable join(std::vector<Part>& parts, const RecordingPlan& plan, Hold hold) {
  const TimeRange span = span_of(parts, plan);
  Part& first = parts.front();
  if (!(span.start < span.end)) {
    first.read.report.problem("no overlap", 0, [] {
      return std::string("the files with commands do not overlap: at no time are all commands known");
    });
    return {};
  }
  const JoinedRows rows = join_rows(parts, span);
  note_left_out(parts, span, first.read.report);
  note_late_readings(parts, plan, span, first.read.report);
  CsvTable table = table_of(parts, rows);
  fill_commands_of(parts, plan, hold, rows, table);
  return table;
}

}  // namespace

ReadRecording join_tables(const RecordingSource& source, const RecordingPlan& plan, const MeasuredFile& file,
                          std::vector<ReadTable> tables) {
  if (file.with.empty()) return {std::move(tables.front().report), std::move(tables.front().table), {}};
  std::vector<Part> parts = parts_of(source, plan, file, std::move(tables));
  for (std::size_t p = 1; p < parts.size() && !has_problems(parts); ++p)
    set_clock(file.with[p - 1], plan, source.hold, parts.front(), parts[p]);
  CsvTable table;
  if (!has_problems(parts)) {
    for (Part& part : parts) take_times(parts.front(), part);
    check_overlap(parts);
  }
  if (!has_problems(parts)) table = join(parts, plan, source.hold);
  ReadRecording joined{std::move(parts.front().read.report), std::move(table), {}};
  for (std::size_t p = 1; p < parts.size(); ++p) joined.further.push_back(std::move(parts[p].read.report));
  return joined;
}

}  // namespace lacuna
