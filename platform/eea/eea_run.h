#pragma once

#include "eea/definition/eea_definition.h"
#include "eea/definition/eea_journal.h"
#include "eea/definition/evaluations.h"
#include "foundation/work.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace lacuna {

/// Progress of a run, reported after each generation.
struct EeaProgress {
  int pass = 0, passes = 0;
  Phase phase = Phase::trial;
  int generation = 0, generations = 0;
  double best = 0.0;                           ///< of the phase: score of a model, or fitness of a test
  std::uint64_t evaluations = 0, invalid = 0;  ///< of models and tests, in this pass
};

/// One replicate of an experiment.
struct EeaRun {
  const EeaDefinition& definition;
  EeaJournal& journal;
  std::uint64_t seed = 1;
  int replicate = 1;  ///< from 1
  Work work = {};     ///< ends early after a generation, or while the target is waited for; `progress` below reports
  std::vector<double> truth;          ///< values of the model's free parameters; only for the objective metric
  const RobotSpec* target = nullptr;  ///< of a simulated target; only for the objective metric
  std::function<void(const EeaProgress&)> progress;
  Evaluations* evaluations = nullptr;  ///< where models are simulated; null: in this process

  /// The random streams of a search, which adds generation and individual.
  std::vector<std::uint64_t> key(Phase phase, int pass) const {
    return {seed, static_cast<std::uint64_t>(replicate), static_cast<std::uint64_t>(phase),
            static_cast<std::uint64_t>(pass)};
  }
  /// Between two generations: reports progress, stores the state, and throws `Interrupted` when the work is to end.
  void end_generation(const EeaState& state, const EeaProgress& progress) const;
};

}  // namespace lacuna
