#pragma once

#include "config/experiment.h"
#include "diagnosis/base_solution.h"

#include <vector>

namespace lacuna {

/// A trial's start is told by the model as it is, and what is missing may have misled it: its deviation is so much
/// wider.
inline constexpr double kDoubtOfStart = 100.0;

inline constexpr double kUsualBlock = 0.5;  ///< s

/// What is cut. Everything referred to must live until `cut_trials` returns.
struct CutTask {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;
  const std::vector<double>& values;  ///< of the fitted model
  double segment = 0.0;               ///< s; 0: `usual_segment`, or `kUsualBlock` of free runs
  int threads = 1;
};

/// The longest trial that is not held out, s; 0 if there is none.
double longest_fit_trial(const std::vector<Trial>& trials);

/// 1 s where the trials that are not held out have 12 s together, so that enough segments are left to judge by, else
/// 0.5 s. In longer ones, more of what no model has builds up, and work grows with the square of their length.
double usual_segment(const std::vector<Trial>& trials);

/// Throws `BadInput` where a user asks for segments of next to no length, or of more than every trial that is not held
/// out has. The usual length may be longer: `cut_trials` then takes what there is.
void check_segment(double segment, const std::vector<Trial>& trials);

/// The trials that are not held out, cut into segments of about `segment` s whose starts are told by the measurements
/// around them; whole, where an effect has a state that no sensor tells; into blocks of free runs (free_run.h) where
/// not all positions are measured. Throws `Error` where nothing is left to diagnose.
BaseSolution cut_trials(const CutTask& task);

}  // namespace lacuna
