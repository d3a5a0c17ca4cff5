#pragma once

#include <lacuna/model_encoding.h>
#include <lacuna/objective_metric.h>
#include <lacuna/test_encoding.h>
#include <lacuna/test_fitness.h>

#include "evaluation/component_choice.h"
#include "evaluation/model_definition.h"
#include "evaluation/model_scorer.h"
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

/// Everything that an experiment says about the Estimation-Exploration Algorithm, its plugins found and its settings
/// checked. Const and shared by the replicates.
class EeaDefinition {
 public:
  /// Throws `BadInput` with every problem at its place in the file. `model` is the experiment's. The catalog must live
  /// as long. With `takes_tests` false nothing is made of tests and exploration.
  EeaDefinition(const Experiment& experiment, const PluginCatalog& catalog, ModelDefinition model, bool takes_tests);
  EeaDefinition(const EeaDefinition&) = delete;
  EeaDefinition& operator=(const EeaDefinition&) = delete;

  /// A genome's model; values of effects that it does without are not known. Throws `Error` that names the encoding
  /// where it fails.
  ModelProposal decode_model(const Genome& genome) const;
  Test decode_test(const Genome& genome) const;
  /// What models are driven by to be held against a trial of that test: the commands that a program took, which may
  /// have been late or clipped, where the test is a series of them; else the test itself.
  Test drive_of(Test test, const Trial& trial) const;
  /// A trial as models are held against it: with the sensors that the experiment scores.
  ScoredTrial scored(Test drive, Trial trial) const;

  ModelDefinition model;
  std::unique_ptr<CompiledModel> compiled;
  ModelSpace model_space;
  TestSpace test_space;
  Chosen<ModelEncoding> model_encoding;
  Chosen<TestEncoding> test_encoding;
  Chosen<FitnessMetric> metric;
  Chosen<TestFitness> fitness;
  std::optional<Chosen<ObjectiveMetric>> objective;
  std::vector<std::string> scored_channels;  ///< names; none: all that a trial has measured
  std::vector<std::size_t> seen_channels;    ///< by a test's controller, of the robot's channels; none: all
  SearchPlan estimation, exploration;
  std::size_t models_for_tests = 0;  ///< how many of the best models judge a test
  std::vector<double> sample_times;  ///< of a test, s
  int passes = 1;
  int seeds = 0;
  bool approximate = false;
  bool target_is_program = false;  ///< that keeps its own time
  bool abandon = true, reuse = true;

 private:
  void define_estimation(const Experiment& experiment, const PluginCatalog& catalog, Complaints& complaints);
  void define_exploration(const Experiment& experiment, const PluginCatalog& catalog, Complaints& complaints);
};

}  // namespace lacuna
