#include "measurement/join_tables.h"

#include "foundation/unit.h"
#include "measurement/clock_alignment.h"
#include "measurement/clock_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kSameTime = 1e-6;  ///< of the first file's median interval: one row for both
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// A file with its rows' times.
struct Part {
  ReadTable read;
  std::string name;
  double seconds_per_unit = 1.0;
  TrialClock clock = {};
  double origin = 0.0;  ///< s, what its clock shows at `clock.times` = 0
  double offset = 0.0, skew = 0.0;
  std::vector<double> times = {};  ///< s on the first file's clock, since that one's first sample

  bool has(std::size_t column) const { return !read.table.columns[column].empty(); }
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
  part.origin = (table.time_origin + table.times[part.clock.rows.front()]) * part.seconds_per_unit;
  return part;
}

std::vector<Part> parts_of(const RecordingSource& source, const RecordingPlan& plan, const MeasuredFile& file,
                           std::vector<ReadTable> tables) {
  std::vector<Part> parts = {part_of(std::move(tables.front()), file.path, plan.seconds_per_time_unit)};
  for (std::size_t i = 0; i < file.with.size(); ++i) {
    const std::string& unit = file.with[i].time_unit.empty() ? source.time_unit : file.with[i].time_unit;
    parts.push_back(part_of(std::move(tables[i + 1]), file.with[i].path, parse_unit(unit)->to_si));
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

void note_alignment(const FurtherFile& file, const ClockAlignment& found, const Part& first, Part& part) {
  part.read.report.doubt("clock found", 0, [&] {
    std::string text = fmt::format("its clock was found from `{}`: ", found.by);
    if (!file.offset)
      text += fmt::format("offset = {:.6g} ± {:.2g} s to that of {}", found.offset, found.offset_error, first.name);
    if (!file.skew)
      text += fmt::format("{}skew = {:.4g} ± {:.2g}", file.offset ? "" : ", ", found.skew, found.skew_error);
    return text + "; standard errors. A delay of a drive or a sensor is part of the offset";
  });
}

/// Takes what the experiment says of a clock, or finds it.
void set_clock(const FurtherFile& file, const RecordingPlan& plan, Hold hold, const Part& first, Part& part) {
  part.offset = file.offset.value_or(0.0);
  part.skew = file.skew.value_or(0.0);
  if (file.offset && file.skew) return;
  AlignmentTask task{file.between, part.skew, !file.skew};
  const auto answer = align_clocks(signals_of(first, plan, hold), signals_of(part, plan, hold), task);
  if (const std::string* reason = std::get_if<std::string>(&answer)) {
    part.read.report.problem("clock", 0, [&] {
      return fmt::format(
          "the offset of its clock to that of {} was not found: {}. Write it, as in offset = \"0.2 s\", or where to "
          "look "
          "for it, as in between = [\"-0.5 s\", \"0.5 s\"]",
          first.name, *reason);
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
    part.times.push_back(part.origin - first.origin + time + part.offset + part.skew * time);
}

/// Where every command is known, within what the first file spans.
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
          "has no time in common with {}: it runs from {:.9g} s to {:.9g} s on that file's clock, which runs from "
          "{:.9g} "
          "s to {:.9g} s. State how the clocks differ, as in offset = \"-3 s\", or write offset = \"auto\"",
          first.name, first.origin + part.times.front(), first.origin + part.times.back(),
          first.origin + first.times.front(), first.origin + first.times.back());
    });
  }
}

/// A row of the joined table: one of each part, or none.
struct JoinedRow {
  double time = 0.0;
  std::vector<std::size_t> of_part;
};

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::vector<JoinedRow> join_rows(const std::vector<Part>& parts, const TimeRange& span) {
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
  std::vector<JoinedRow> rows;
  for (const Sample& sample : samples) {
    const bool joins =
        !rows.empty() && sample.time - rows.back().time <= same && rows.back().of_part[sample.part] == kNone;
    if (!joins) rows.push_back({sample.time, std::vector<std::size_t>(parts.size(), kNone)});
    rows.back().of_part[sample.part] = sample.row;
  }
  return rows;
}

CsvTable table_of(const std::vector<Part>& parts, const std::vector<JoinedRow>& rows) {
  const Part& first = parts.front();
  const CsvTable& base = first.read.table;
  CsvTable table;
  table.time_origin = base.time_origin;
  table.dated = base.dated;
  table.columns.resize(base.columns.size());
  for (const JoinedRow& row : rows) {
    table.times.push_back(base.times[first.clock.rows.front()] + row.time / first.seconds_per_unit);
    table.lines.push_back(row.of_part.front() == kNone ? 0 : base.lines[row.of_part.front()]);
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      double value = kNoValue;
      for (std::size_t p = 0; p < parts.size(); ++p)
        if (row.of_part[p] != kNone && parts[p].has(c)) value = parts[p].read.table.columns[c][row.of_part[p]];
      table.columns[c].push_back(value);
    }
  }
  return table;
}

/// What a column says at a time between its samples.
double value_at(const Part& part, std::size_t column, double time, Hold hold) {
  const auto after = std::upper_bound(part.times.begin(), part.times.end(), time);
  if (after == part.times.begin()) return kNoValue;
  const auto before = static_cast<std::size_t>(after - part.times.begin()) - 1;
  const std::vector<double>& values = part.read.table.columns[column];
  const double value = values[part.clock.rows[before]];
  if (hold == Hold::zero_order || after == part.times.end()) return value;
  const double share = (time - part.times[before]) / (part.times[before + 1] - part.times[before]);
  return value + share * (values[part.clock.rows[before + 1]] - value);
}

/// The first row is a sample of one file; the commands that another has at that time are known.
void fill_first_row(const std::vector<Part>& parts, const RecordingPlan& plan, Hold hold, double time,
                    CsvTable& table) {
  for (std::size_t c = plan.sensors.size(); c < table.columns.size(); ++c)
    for (const Part& part : parts)
      if (part.has(c) && std::isnan(table.columns[c].front()))
        table.columns[c].front() = value_at(part, c, time, c < columns_of(plan).size() ? hold : Hold::zero_order);
}

void note_left_out(const std::vector<Part>& parts, const TimeRange& span, FileReport& report) {
  const Part& first = parts.front();
  if (span.start == first.times.front() && span.end == first.times.back()) return;
  report.note("overlap", 0, [&] {
    return fmt::format("used from {:.9g} s to {:.9g} s, where the commands of the other file are known",
                       first.origin + span.start, first.origin + span.end);
  });
}

CsvTable join(std::vector<Part>& parts, const RecordingPlan& plan, Hold hold) {
  const TimeRange span = span_of(parts, plan);
  const std::vector<JoinedRow> rows = join_rows(parts, span);
  note_left_out(parts, span, parts.front().read.report);
  CsvTable table = table_of(parts, rows);
  if (!rows.empty()) fill_first_row(parts, plan, hold, rows.front().time, table);
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
