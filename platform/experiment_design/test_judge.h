#pragma once

#include "experiment_design/next_test.h"
#include "experiment_design/candidate_predictor.h"
#include "evaluation/model/component_choice.h"

#include <array>
#include <optional>
#include <string>

namespace lacuna {

/// Computes the worth of tests of `command_series` for telling two candidates apart (next_test.h). Const and shared by
/// threads, each with a worker of its own.
class TestJudge {
 public:
  /// Throws `Error` as `next_test` does. The task must outlive it.
  explicit TestJudge(const NextTestTask& task);

  const GenomeLayout& layout() const { return layout_; }
  /// A random test that a line can express (test_line.h).
  Genome random(RandomStream& random) const;
  /// In the worse direction; below 0 where the test cannot be carried out. `setup`: of the rig, by name.
  double nats(const Genome& genome, int worker, const std::string& setup = {}) const;
  /// Number of trials until `kDecisiveNats`; more trials of one test also improve the other candidate. Infinite: more
  /// than a million.
  double trials_needed(const Genome& genome, const std::string& setup = {}) const;

 private:
  /// The predictions of both candidates for a test, and those of each after its refit to the other's.
  struct Judgement {
    std::array<CandidatePrediction, 2> truths, refitted;
    std::array<double, 2> trusted;  ///< share of the difference that remains after the refit of each
  };

  /// Nothing where one of the candidates cannot carry the test out.
  std::optional<Judgement> judgement(const Genome& genome, const std::string& setup, int worker) const;
  double worse(const Judgement& judgement, double trials) const;
  double score(const Eigen::VectorXd& left) const;

  const NextTestTask& task_;
  Chosen<TestEncoding> encoding_;
  Chosen<TestFitness> fitness_;
  std::array<CandidatePredictor, 2> candidates_;
  GenomeLayout layout_;
};

}  // namespace lacuna
