#pragma once

#include "diagnosis/refit.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// Which fold each segment belongs to: a trial each where there are enough of them, else blocks of neighbouring
/// segments of a trial.
std::vector<std::size_t> folds(const std::vector<Segment>& segments);

/// Deviance (−2 log likelihood under the loss of the fits, but for a constant) of every segment as predicted from the
/// other folds: the values are those of one Gauss–Newton step from the full fit that leaves the fold out; the segment's
/// start is free. Whatever is fitted in a round, effects and forces of any form, is judged by this.
Eigen::VectorXd held_out_deviance(const Refit& fit, const std::vector<std::size_t>& folds);

/// What the values move by when a fold is left out, in coordinates; by fold. A fit that did not converge is taken for
/// the least deviance of all folds.
std::vector<Eigen::VectorXd> steps_without(const Refit& fit, const std::vector<std::size_t>& folds);

/// A difference of held-out log likelihood, nats, with a paired bootstrap over blocks of segments.
struct Gain {
  double value = 0.0;
  double standard_error = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
};

/// By how much `better` predicts what was left out better than `worse`; both held-out deviances by segment.
Gain gain(const Eigen::VectorXd& worse, const Eigen::VectorXd& better, std::uint64_t seed);

}  // namespace lacuna
