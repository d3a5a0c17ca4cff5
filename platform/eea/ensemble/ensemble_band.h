#pragma once

#include <lacuna/time_series.h>

#include <vector>

namespace lacuna {

/// The predictions of a test by several models together: one row per sample, one column per channel, in the channels'
/// units.
struct EnsembleBand {
  TimeSeries::Samples mean;
  TimeSeries::Samples half_width;  ///< half-width of the 95 % band
};

/// The band in which a new reading lies with 95 % if the right model is one like these: the quadratic sum of Student's
/// t times the standard deviation between the models, for one more of their kind, and the noise of a reading.
/// `predictions`: one per model, all of one size, at least one; a single one has no spread. `noise`: standard deviation
/// of a reading, one per channel; a value that is not finite is unknown and counts as zero.
EnsembleBand band_of(const std::vector<TimeSeries::Samples>& predictions, const std::vector<double>& noise);

}  // namespace lacuna
