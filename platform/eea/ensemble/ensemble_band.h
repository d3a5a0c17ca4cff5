#pragma once

#include <lacuna/time_series.h>

#include <vector>

namespace lacuna {

/// What several models say of a test together: one row a sample, one column a channel, in the channels' units.
struct EnsembleBand {
  TimeSeries::Samples mean;
  TimeSeries::Samples half_width;  ///< of the 95 % band about it
};

/// Where a new reading lies with 95 % if the right model is one like these: in quadrature Student's t times the
/// standard deviation between the models, for one more of their kind, and the noise of a reading. `predictions`: one a
/// model, all of one size, at least one; a single one has no spread. `noise`: standard deviation of a reading, one a
/// channel; what is not finite is not known and counts as none.
EnsembleBand band_of(const std::vector<TimeSeries::Samples>& predictions, const std::vector<double>& noise);

}  // namespace lacuna
