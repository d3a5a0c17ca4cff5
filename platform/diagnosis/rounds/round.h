#pragma once

#include "diagnosis/refit/cross_validation.h"
#include "diagnosis/residual_force/force_formula.h"
#include "diagnosis/residual_force/free_force.h"
#include "diagnosis/rounds/base_bench.h"
#include "diagnosis/screening/screening.h"
#include "fitting/progress.h"
#include "fitting/progress_meter.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// An effect that was refitted.
struct Rival {
  std::size_t hypothesis = 0;  ///< of the round
  double deviance = 0.0;       ///< score of its best probe
  Refit fit;
  Eigen::VectorXd held_out;  ///< deviance by block
  Gain gain;                 ///< over the round's base
};

/// One look for the effect that a model lacks: screened all, refitted few.
struct Round {
  BaseSolution base;  ///< refitted under the noise
  RowBins bins;
  ForceResponses forces;
  NoiseModel noise;
  std::vector<Eigen::MatrixXd> factors;  ///< of the noise
  Folds folds;
  Refit fit;  ///< of the base
  Eigen::VectorXd held_out;
  std::vector<Hypothesis> hypotheses;
  std::vector<Untestable> untestable;
  Screening screening;
  std::vector<Rival> rivals;  ///< the largest gain first
  bool stopped = false;       ///< by the time limit, while rivals were refitted; the rivals are those that were
  std::vector<std::string> not_examined;  ///< rivals that were not, "name @ where"
  FreeForceTest free_force;
  std::vector<ForceFormula> formulas;  ///< where the free force is beyond chance

  explicit Round(RowBins thinned) : bins(std::move(thinned)), noise(bins, {}) {}
};

struct RoundTask {
  const PluginCatalog& catalog;
  const Contender& contender;
  const BaseSolution& start;  ///< as cut for the contender, whose values it has
  Moving moving;              ///< how the round settles on them (base_bench.h)
  const std::vector<std::string>& among;
  std::uint64_t seed = 1;
  int threads = 1;
  ProgressMeter& meter;  ///< gets `kRoundParts` parts
};

inline constexpr int kRoundParts = 4;
/// Of the test whether structure is left: that no library explains something is said on stronger evidence than that one
/// of its effects does, since the noise is not quite as it is modelled.
inline constexpr double kFreeForceLevel = 0.001;

Round run_round(const RoundTask& task);

/// The solution for a refit of a model with other values: segments, states and their difference steps alone.
BaseSolution without_values(BaseSolution base);

/// Another model than the round's, refitted under its noise; with the timing of commands beside the values even where
/// the round's model does without, whose delay may do the same.
Refit refit_under(const Round& round, const Contender& model, int threads, RefitEffort effort = {});

}  // namespace lacuna
