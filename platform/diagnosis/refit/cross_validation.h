#pragma once

#include "diagnosis/refit/folds.h"
#include "diagnosis/refit/refit.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// By segment and block (RowBins::blocks): a trial is a fold where there are enough of them, else neighbouring blocks
/// of a trial are.
Folds folds(const std::vector<Segment>& segments, const RowBins& bins);

/// Deviance (−2 log likelihood under the loss of the fits, but for a constant) of every block of all segments, one
/// after the other, as predicted from the other folds: the values are those of one Gauss–Newton step from the full fit
/// that leaves the fold out; the segment's start is free, and what is remembered of the block before is taken from the
/// measurements. Whatever is fitted in a round, effects and forces of any form, is judged by this.
Eigen::VectorXd held_out_deviance(const Refit& fit, const Folds& folds);

/// What the values move by when a fold is left out, in coordinates; by fold. A fit that did not converge is taken for
/// the least deviance of all folds.
std::vector<Eigen::VectorXd> steps_without(const Refit& fit, const Folds& folds);

/// A difference of held-out log likelihood, nats, with a paired bootstrap over blocks.
struct Gain {
  double value = 0.0;
  double standard_error = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
  bool operator==(const Gain&) const = default;
};

/// By how much `better` predicts what was left out better than `worse`; both held-out deviances by block.
Gain gain(const Eigen::VectorXd& worse, const Eigen::VectorXd& better, std::uint64_t seed);

}  // namespace lacuna
