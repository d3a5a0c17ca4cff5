#pragma once

#include "config/experiment.h"
#include "diagnosis/rounds/base_bench.h"

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
  double segment = 0.0;               ///< s; 0: the usual length, or `kUsualBlock` of free runs
  int threads = 1;
};

/// The longest trial that is not held out, s; 0 if there is none.
double longest_fit_trial(const std::vector<Trial>& trials);

/// Throws `BadInput` where a user asks for segments of next to no length, or of more than every trial that is not held
/// out has.
void check_segment(double segment, const std::vector<Trial>& trials);

/// A model whose way from the segments' starts on decides how long they may be: that which is cut for, or that with
/// effects added. Both have the same states.
struct Follower {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<double>& values;
  Moving moving = Moving::all;  ///< to begin with
};

/// The trials that are not held out, cut into segments of about `segment` s whose starts are told by the measurements
/// around them; whole, where an effect has a state that no sensor tells; into blocks of free runs (free_run.h) where
/// not all positions are measured. Values and states are those of `follower`, settled (base_bench.h) on segments that
/// are longer than a second.
///
/// The usual length is 5 s, so that slow errors have time to show; 2.5, 1.25 or 1 s where an uncertain start moves the
/// prediction by far more than the noise (fitting/stages.h), or where the model leaves far more over than on segments
/// of 1 s, which it follows from farther off. Throws `Error` where nothing is left to diagnose.
BaseSolution cut_trials(const CutTask& task, const Follower& follower);
BaseSolution cut_trials(const CutTask& task);

}  // namespace lacuna
