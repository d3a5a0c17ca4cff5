#pragma once

#include "fitting/starts/start_fit.h"
#include "fitting/starts/start_states.h"

#include <optional>
#include <vector>

namespace lacuna {

/// A stretch whose prediction is compared with the data, and its initial state.
struct Segment {
  Stretch stretch;
  Eigen::Index run_in = 0;             ///< samples at the beginning that only fill memories and do not count
  std::optional<WarmUp> warm_up = {};  ///< simulated before the stretch
  StartState start;                    ///< guess; exact for the components that are not unknown
  std::vector<int> unknown;            ///< components of the start that are fitted
  Eigen::VectorXd deviation;           ///< prior standard deviation of each unknown about its guess
  std::vector<Eigen::Index> rows,
      columns;  ///< the measured values that count: row in the stretch, channel of the trial

  /// The first sample of the trial after the run-in. The unknown initial state contains the effect of earlier forces.
  Eigen::Index first_counted() const { return stretch.first + run_in; }
};

/// From the first sample after the run-in to the last, s.
double duration_of(const Segment& segment, const std::vector<Trial>& trials);

/// Cuts a trial into equal stretches of about `length` s; not positive, or longer than the trial: one.
std::vector<Stretch> cut(const Trial& trial, std::size_t index, double length);

/// Cuts the fit trials into segments for a stage. A segment at a trial's start follows the trial: exact; `from_data`,
/// its state estimated on its first samples with `values`, which are then not scored; or free. Inner segments are free.
/// Segments with no more measured values than unknowns carry no information and are left out, as are those whose start
/// cannot be simulated. Inner segments are simulated from `run_in` s earlier, so that delays, lags and other memories,
/// which no reading shows, are filled where the segment begins to count. At a trial's start, where earlier commands are
/// unknown, the first samples are not scored; with such memories the model's first `kLongestMemory` s are not scored.
std::vector<Segment> make_segments(const TrialPredictor& predictor, const StartStates& states, double length,
                                   const std::vector<double>& values, double run_in = 0.0);

/// Whether all starts agree within a tenth of their prior deviations.
bool same_starts(const std::vector<Segment>& a, const std::vector<Segment>& b);

/// At most `most` of the segments, evenly spread.
std::vector<Segment> thinned(std::vector<Segment> segments, std::size_t most);

}  // namespace lacuna
