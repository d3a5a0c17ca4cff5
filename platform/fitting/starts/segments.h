#pragma once

#include "fitting/starts/head_fit.h"
#include "fitting/starts/start_states.h"

#include <optional>
#include <vector>

namespace lacuna {

/// A stretch whose prediction is compared with the data, and what is known of its start.
struct Segment {
  Stretch stretch;
  Eigen::Index run_in = 0;             ///< samples at the beginning that only fill what has a memory, and do not count
  std::optional<WarmUp> warm_up = {};  ///< simulated before the stretch
  StartState start;                    ///< guess; exact for the components that are not unknown
  std::vector<int> unknown;            ///< components of the start that are fitted
  Eigen::VectorXd deviation;           ///< prior standard deviation of each unknown about its guess
  std::vector<Eigen::Index> rows,
      columns;  ///< the measured values that count: row in the stretch, channel of the trial

  /// The first sample of the trial after the run-in. What forces do before is told by the start, which is unknown.
  Eigen::Index first_counted() const { return stretch.first + run_in; }
};

/// From the first sample after the run-in to the last, s.
double duration_of(const Segment& segment, const std::vector<Trial>& trials);

/// Cuts a trial into equal stretches of about `length` s; not positive, or longer than the trial: one.
std::vector<Stretch> cut(const Trial& trial, std::size_t index, double length);

/// Cuts the trials that are not held out into segments for a stage. A segment at a trial's start
/// follows what the trial knows: exact; `from_data`, its state estimated on the head with `values`, which is
/// then not scored; or free. Inner segments are free. Segments that hold no more measured values than
/// unknowns tell nothing and are left out, as are heads that cannot be simulated. Inner segments are simulated from
/// `run_in` s earlier, so that delays, lags and other memories, which no reading tells, are filled where they begin to
/// count. At a trial's start, where what was before is unknown, the head is not scored, and of a model that has such
/// memories not the first `kLongestMemory` s.
std::vector<Segment> make_segments(const TrialPredictor& predictor, const StartStates& states, double length,
                                   const std::vector<double>& values, double run_in = 0.0);

/// Whether all starts agree within a tenth of their prior deviations.
bool same_starts(const std::vector<Segment>& a, const std::vector<Segment>& b);

/// At most `most` of the segments, evenly spread.
std::vector<Segment> thinned(std::vector<Segment> segments, std::size_t most);

}  // namespace lacuna
