#include "measurement/decode_tables.h"

#include "foundation/counted.h"
#include "measurement/decode.h"
#include "measurement/encoding_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lacuna {
namespace {

constexpr double kSmallestNumber = 1e-290;  ///< below it a number is memory that nobody wrote to
constexpr double kLongestTick = 20.0;       ///< median intervals: a clock that wraps goes on that soon

void drop_unwritten(const std::vector<const PlannedColumn*>& planned, ReadTable& read) {
  for (std::size_t c = 0; c < planned.size(); ++c) {
    std::size_t count = 0, first = 0;
    for (std::size_t row = 0; row < read.table.columns[c].size(); ++row) {
      double& value = read.table.columns[c][row];
      if (value == 0.0 || !(std::abs(value) < kSmallestNumber)) continue;
      if (count++ == 0) first = row;
      value = std::nan("");
    }
    if (count == 0) continue;
    read.report.doubt("unwritten " + planned[c]->mapping->column, read.table.lines[first], [&] {
      return fmt::format("column `{}` has {} below 1e-290, which no device measures: taken as missing",
                         planned[c]->mapping->column, counted(count, "number"));
    });
  }
}

/// A column of all good tables, a vector for each trial.
struct ColumnParts {
  std::vector<std::vector<double>> values;
  std::vector<std::pair<std::size_t, std::vector<std::size_t>>> from;  ///< table and rows of each
};

ColumnParts parts_of(const std::vector<ReadTable>& tables, std::size_t column) {
  ColumnParts parts;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    if (tables[t].report.has_problems() || tables[t].table.columns[column].empty()) continue;
    for (std::vector<std::size_t>& rows : rows_by_trial(tables[t].table)) {
      std::vector<double> values;
      for (const std::size_t row : rows) values.push_back(tables[t].table.columns[column][row]);
      parts.values.push_back(std::move(values));
      parts.from.emplace_back(t, std::move(rows));
    }
  }
  return parts;
}

std::string meaning_of(const Encoding& encoding) {
  switch (encoding.kind) {
    case EncodingKind::sign_bit:
      return fmt::format("negative values are written as {:.0f} + their size", encoding.modulus);
    case EncodingKind::twos_complement:
      return fmt::format("negative values are written as {:.0f} minus their size", encoding.modulus);
    case EncodingKind::wraps: return fmt::format("it starts again at {:.6g}", encoding.modulus);
    case EncodingKind::automatic:
    case EncodingKind::plain: break;
  }
  return {};
}

void note_encoding(const ColumnMapping& mapping, const std::string& section, const FoundEncoding& found,
                   const ColumnParts& parts, std::vector<ReadTable>& tables) {
  std::size_t place = found.first;
  for (std::size_t p = 0; p < parts.values.size(); ++p) {
    if (place >= parts.values[p].size()) {
      place -= parts.values[p].size();
      continue;
    }
    ReadTable& read = tables[parts.from[p].first];
    read.report.doubt("encoding of " + mapping.column, read.table.lines[parts.from[p].second[place]], [&] {
      return fmt::format(
          "column `{}` jumps {}, here for the first time, because {}; read so. State it in target.{}.{}: encoding = "
          "\"{}\"; if it is wrong, encoding = \"plain\"",
          mapping.column, counted(found.jumps, "time"), meaning_of(found.encoding), section, mapping.channel,
          to_string(found.encoding));
    });
    return;
  }
}

/// Of one column, in all tables.
void decode_column(std::size_t column, const PlannedColumn& planned, const std::string& section,
                   std::vector<ReadTable>& tables) {
  Encoding encoding = planned.mapping->encoding;
  if (encoding.kind == EncodingKind::plain) return;
  ColumnParts parts = parts_of(tables, column);
  if (encoding.kind == EncodingKind::automatic) {
    const std::optional<FoundEncoding> found = guess_encoding(parts.values, planned.mapping->unit);
    if (!found) return;
    note_encoding(*planned.mapping, section, *found, parts, tables);
    encoding = found->encoding;
  }
  for (std::size_t p = 0; p < parts.values.size(); ++p) {
    decode(encoding, parts.values[p]);
    std::vector<double>& values = tables[parts.from[p].first].table.columns[column];
    for (std::size_t i = 0; i < parts.values[p].size(); ++i) values[parts.from[p].second[i]] = parts.values[p][i];
  }
}

double median_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] > times[i - 1]) steps.push_back(times[i] - times[i - 1]);
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// A power of two that whole stamps stay below, come near, and start again from 0 at; 0: none.
double wrap_of_clock(const CsvTable& table) {
  const std::vector<double>& times = table.times;
  const double near = kLongestTick * median_step(times);
  const bool whole = std::all_of(times.begin(), times.end(), [](double time) { return time == std::round(time); });
  for (const int bits : {16, 24, 31, 32}) {
    const double modulus = std::ldexp(1.0, bits);
    std::size_t wraps = 0;
    bool all = whole;
    for (std::size_t i = 0; i < times.size() && all; ++i) {
      const double stamp = table.time_origin + times[i];
      all = stamp >= 0.0 && stamp < modulus;
      if (i == 0 || times[i] >= times[i - 1]) continue;
      all = all && stamp < near && table.time_origin + times[i - 1] > modulus - near;
      ++wraps;
    }
    if (all && wraps > 0) return modulus;
  }
  return 0.0;
}

/// A clock never goes back: each step back is one more turn, however long the pause.
void unwrap_clock(double modulus, std::vector<double>& times) {
  double turns = 0.0, before = times.empty() ? 0.0 : times.front();
  for (double& time : times) {
    if (time < before) turns += 1.0;
    before = time;
    time += turns * modulus;
  }
}

}  // namespace

void decode_clock(Encoding encoding, const std::string& time_column, ReadTable& read) {
  std::vector<double>& times = read.table.times;
  if (encoding.kind == EncodingKind::automatic && !read.table.dated && read.table.trial_names.empty()) {
    const double modulus = wrap_of_clock(read.table);
    if (modulus == 0.0) return;
    encoding = {EncodingKind::wraps, modulus};
    const auto back = std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return b < a; });
    read.report.doubt("clock", read.table.lines[static_cast<std::size_t>(back - times.begin()) + 1], [&] {
      return fmt::format(
          "the clock, column `{}`, starts again at {:.0f}; read so. State it in target.time: encoding = \"{}\"; if it "
          "is wrong, encoding = \"plain\"",
          time_column, modulus, to_string(encoding));
    });
  }
  if (encoding.kind == EncodingKind::wraps) unwrap_clock(encoding.modulus, times);
}

void decode_tables(const RecordingPlan& plan, std::vector<ReadTable>& tables) {
  const std::vector<const PlannedColumn*> planned = columns_of(plan);
  for (ReadTable& read : tables)
    if (!read.report.has_problems()) drop_unwritten(planned, read);
  const std::size_t sensors = plan.sensors.size();
  for (std::size_t c = 0; c < sensors + plan.commands.size(); ++c)
    decode_column(c, *planned[c], c < sensors ? "sensors" : "commands", tables);
}

}  // namespace lacuna
