#pragma once

#include "foundation/score_kind.h"
#include "storage/core/records.h"

#include <lacuna/genome.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a run of the Estimation-Exploration Algorithm leaves behind. Models and tests are numbered from 0 within their
/// run; the key of a row is the run's number × 2^40 + that number (+ 1, since 0 is the run itself).
namespace lacuna {

/// A candidate model of one generation of an estimation phase.
struct ModelRow {
  std::uint64_t number = 0;
  int pass = 0;
  int generation = 0;
  std::array<std::optional<std::uint64_t>, 2> parents = {};
  Genome genome = {};
  ScoreKind kind = ScoreKind::full;
  bool reused = false;                    ///< an identical model was evaluated before; its scores count
  double score = kNotKnown;               ///< of all trials so far together; −0.0 comes back as 0.0
  std::vector<double> trial_scores = {};  ///< of trial 0, 1 ... of this run as far as they were begun; the last of an
                                          ///< abandoned model is a lower bound
  std::string reason = {};                ///< why it is invalid
};

/// A candidate test of one generation of an exploration phase.
struct TestRow {
  std::uint64_t number = 0;
  int pass = 0;  ///< of the exploration phase; 0: before the first trial
  int generation = 0;
  std::array<std::optional<std::uint64_t>, 2> parents = {};
  Genome genome = {};
  bool valid = true;
  double fitness = kNotKnown;  ///< larger is better
  std::string reason = {};     ///< why it is invalid
};

/// A test carried out on the target, or a recorded trial that the run uses.
struct TargetTrialRow {
  int number = 0;                          ///< within the run, from 0
  std::optional<std::uint64_t> test = {};  ///< the test's number; none: recorded
  std::string file = {};                   ///< of a recorded trial, as the experiment names it
  bool for_transfer = false;               ///< carried out after the last pass, to see how its test transfers
  double predicted_fitness = kNotKnown;    ///< of the test, by the models that chose it
  double measured_fitness = kNotKnown;     ///< of the same test on the target
  double surprise = kNotKnown;             ///< score, on this trial alone, of the best model before it was fitted to it
};

/// One figure of the objective metric about the best model of a pass.
struct ObjectiveRow {
  std::string name;  ///< address, pattern of addresses, or what the metric calls it
  std::string unit;
  double value = kNotKnown;
};

/// One of the different models that a pass carries over: the best of each structure and restart first.
struct EnsembleRow {
  std::uint64_t model = 0;
  double score = kNotKnown;
  std::string structure = {};       ///< which hypothesis it is of; empty: there is only one
  std::vector<double> values = {};  ///< in the order of the run's free values, SI
};

/// How a pass ended. Counts are of this pass alone.
struct PassRow {
  int number = 0;
  std::optional<std::uint64_t> best_model = {};
  double best_score = kNotKnown;
  std::optional<std::uint64_t> best_test = {};  ///< that exploration chose
  double best_fitness = kNotKnown;
  std::uint64_t evaluations = 0;  ///< of models: scores asked for
  std::uint64_t abandoned = 0, reused = 0, invalid = 0;
  std::uint64_t steps = 0;  ///< integration steps of model evaluations
  std::uint64_t test_evaluations = 0, invalid_tests = 0, test_steps = 0;
  std::vector<double> best_values = {};  ///< of the best model, in the order of the run's free values, SI
  std::vector<ObjectiveRow> objective = {};
  std::vector<EnsembleRow> ensemble = {};
  std::vector<int> set_aside = {};  ///< numbers of trials that were too hard and did not count
  std::string stopped = {};         ///< why the run ended with it, before its last pass; a sentence
};

/// Settings of a run, stored once when it begins.
struct EeaRunRecord {
  int replicate = 1;                       ///< from 1
  std::string metric = {};                 ///< that models are scored by
  std::string fitness = {};                ///< of tests; empty where none are searched for
  std::string fitness_unit = {};           ///< SI; empty where it was not kept
  std::vector<FreeValueRecord> free = {};  ///< of the models
  std::vector<double> truth = {};  ///< one a free value, of a simulated target; NaN where it has none; empty: all
  std::vector<std::string> model_genes = {};  ///< names, in genome order
  std::vector<std::string> test_genes = {};
  int passes = 0;
};

/// A place to go on from. `state` is the algorithm's own.
struct CheckpointRow {
  std::vector<double> state;
};

}  // namespace lacuna
