#pragma once

#include "diagnosis/base_solution.h"
#include "evaluation/model_definition.h"

#include <vector>

namespace lacuna {

inline constexpr double kUsualShift = 0.25;  ///< of a sample interval

/// By segment, bins × 1: how the residual changes when all commands act later, by sample interval; told from acting
/// `shift` of an interval later. Within one interval that is a matter of recording (which side of a sample a command is
/// held on), no effect, and is fitted beside the model's values. Empty where nothing is commanded.
std::vector<Eigen::MatrixXd> timing_columns(const CompiledModel& model, const ModelDefinition& definition,
                                            const BaseSolution& base, const RowBins& bins, int threads,
                                            double shift = kUsualShift);

/// s, between commands: the longest mean of a trial; 0 where nothing is commanded.
double longest_sample_interval(const std::vector<Trial>& trials);

}  // namespace lacuna
