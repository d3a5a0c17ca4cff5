#pragma once

#include <lacuna/model_encoding.h>
#include <lacuna/objective_metric.h>
#include <lacuna/test_encoding.h>

#include "eea/definition/test_value.h"
#include "evaluation/model/component_choice.h"
#include "evaluation/model/model_definition.h"
#include "evaluation/scoring/model_scorer.h"
#include "evaluation/scoring/phenotypes.h"
#include "evolution/operator_breeder.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace lacuna {

/// A search of the experiment with what breeds for it.
struct SearchPlan {
  Chosen<SearchStrategy> strategy;
  std::unique_ptr<OperatorBreeder> breeder;

  const GenomeLayout& layout() const { return breeder->layout(); }
};

/// All settings of an experiment for the Estimation-Exploration Algorithm, with its plugins found and its settings
/// checked. Const and shared by the replicates.
class EeaDefinition {
 public:
  /// Throws `BadInput` with every problem at its place in the file. `model` is the experiment's. The catalog must live
  /// as long. With `takes_tests` false, settings of tests and exploration are not used.
  EeaDefinition(const Experiment& experiment, const PluginCatalog& catalog, ModelDefinition model, bool takes_tests);
  EeaDefinition(const EeaDefinition&) = delete;
  EeaDefinition& operator=(const EeaDefinition&) = delete;

  /// The model of a genome; values of effects that its structure lacks are undefined. Throws `Error` that names the
  /// encoding where it fails.
  ModelProposal decode_model(const Genome& genome) const;
  Test decode_test(const Genome& genome) const;
  /// The drive of models that are compared with a trial of that test: the commands that a program received, which may
  /// have been late or clipped, where the test is a series of commands; else the test.
  Test drive_of(Test test, const Trial& trial) const;
  /// A trial as models of a pass are compared with it: with the sensors that the experiment scores, up to the pass's
  /// horizon, and driven as the experiment says.
  ScoredTrial scored(Test drive, Trial trial, int pass) const;
  /// The whole trial with all its channels, driven as the experiment says.
  ScoredTrial observed(Test drive, Trial trial) const;
  /// Length of a trial that counts in a pass, s; infinite: all of it.
  double horizon(int pass) const;

  ModelDefinition model;
  Phenotypes phenotypes;
  std::unique_ptr<CompiledModel> compiled;
  ModelSpace model_space;
  std::vector<std::size_t> profiled;  ///< indices of the free values that are not genes but found for each model
  ModelSpace gene_space;              ///< without them
  TestSpace test_space;
  Chosen<ModelEncoding> model_encoding;
  Chosen<TestEncoding> test_encoding;
  Chosen<FitnessMetric> metric;
  TestValue value;
  std::optional<Chosen<ObjectiveMetric>> objective;
  std::vector<std::string> scored_channels;  ///< names; none: all channels of a trial
  std::vector<std::size_t> seen_channels;    ///< by a test's controller, of the robot's channels; none: all
  SearchPlan estimation, exploration;
  std::size_t ensemble = 1;          ///< how many different models a pass keeps
  std::vector<double> sample_times;  ///< of a test, s
  int passes = 1;
  int seeds = 0;
  int restarts = 1;
  bool rivals = false;           ///< each restart looks for another structure
  bool replay = false;           ///< models are driven by the commands that the target received
  std::vector<double> horizons;  ///< s, one per pass; the last for all that follow; none: whole trials
  double challenge = 0.0;        ///< 0: no trial is set aside
  int patience = 0;              ///< passes; 0: no limit
  std::optional<double> stop_below;
  bool approximate = false;
  bool target_is_program = false;  ///< that keeps its own time
  bool abandon = true, reuse = true;

 private:
  void define_estimation(const Experiment& experiment, const PluginCatalog& catalog, Complaints& complaints);
  void check_rivals(Complaints& complaints) const;
  void check_horizons(bool takes_tests, Complaints& complaints) const;
  void find_profiled(const EstimationSection& estimate, Complaints& complaints);
  void choose_fitnesses(const ExplorationSection& explore, const PluginCatalog& catalog, Complaints& complaints);
  void define_exploration(const Experiment& experiment, const PluginCatalog& catalog, Complaints& complaints);
};

}  // namespace lacuna
