#pragma once

#include "foundation/recording_source.h"
#include "measurement/csv/csv_table.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// The time stamps of one trial, in seconds of the file's time.
struct TrialClock {
  std::vector<std::size_t> rows;  ///< of the table, in order
  std::vector<double> times;      ///< s since `origin`, one per row
  double origin = 0.0;            ///< s, the file's time at `times` = 0
};

/// Clock of the given rows. Time stamps that go back, or repeat with other values, are problems;
/// repeated rows are left out with a note.
TrialClock read_clock(const CsvTable& table, const std::vector<std::size_t>& rows, double seconds_per_unit,
                      FileReport& report);

/// Cuts a clock into the ranges to be used, one trial each (the whole clock if there are none). Ranges without samples
/// give no trial.
std::vector<TrialClock> cut_to_ranges(const TrialClock& clock, const std::vector<TimeRange>& ranges);

/// A part of a clock, and whether it is held out.
struct ClockPart {
  TrialClock clock;
  bool held_out = false;
  bool goes_on = false;  ///< the samples just before it belong to another part
};

/// Cuts a clock where held-out parts begin and end; in order of time.
std::vector<ClockPart> cut_at_holdout(const TrialClock& clock, const std::vector<TimeRange>& holdout);

/// Median interval between samples, s; NaN with less than two.
double median_interval(std::span<const double> times);

/// Gaps are problems unless a mask covers them; dropped samples, jitter and intervals that look like another unit are
/// notes. For a joined table (join_tables.h) only the first file's rows are checked.
void check_intervals(const TrialClock& whole, const CsvTable& table, const RecordingSource& source, FileReport& report);

/// Whether the file's time `time` lies in one of the ranges.
bool is_in(const std::vector<TimeRange>& ranges, double time);

}  // namespace lacuna
