#pragma once

#include "diagnosis/contender.h"
#include "diagnosis/probe.h"
#include "diagnosis/refit.h"

#include <vector>

namespace lacuna {

/// Whether a column, by segment, is what the others make up together with the starts of `segments`, but for a thirtieth
/// of the power that the starts leave it: from the middle of a trial on, a late reading is a late command.
bool is_among(const std::vector<Eigen::MatrixXd>& column, const std::vector<Eigen::MatrixXd>& others,
              const std::vector<LinearSegment>& segments);

/// The timing of commands (timing.h), unless the model has a value that does the same; empty then. `base`: linearised.
std::vector<Eigen::MatrixXd> timing_beside(const Contender& contender, const BaseSolution& base, const RowBins& bins,
                                           int threads);

/// Whether commands that act later or earlier do what a probe does, at the size that comes next to it. `base` has the
/// contender's timing (`timing_beside`). Single-threaded.
bool acts_as_timing(const Probe& probe, const Contender& contender, const BaseSolution& base, const RowBins& bins);

/// The base's linear segments with the nuisances that the refit has inside their bounds: taken off the residual, and
/// beside the values. What is at its bound is taken off alone.
std::vector<LinearSegment> with_nuisance(const BaseSolution& base, const Refit& fit);

}  // namespace lacuna
