#pragma once

#include <lacuna/test_fitness.h>

#include "eea/definition/eea_definition.h"
#include "eea/definition/eea_state.h"
#include "evaluation/prediction/test_predictor.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// Models that judge tests, with what the trials so far say of the sensors' noise and, where the experiment's test
/// fitness asks for it, of the models' free values. Const and shared by threads, each with a worker of its own.
class Judges {
 public:
  /// The ensemble of the state's last estimation phase, as many as the test fitness takes. Definition and
  /// state must outlive it; simulates on `threads` threads.
  Judges(const EeaDefinition& definition, int threads, const EeaState& state);

  std::size_t size() const { return judges_.size(); }
  int workers() const { return predictor_.workers(); }
  /// That it took to find out what the trials say.
  std::uint64_t steps() const { return steps_; }
  /// Fills one prediction a judge, whose memory is reused, and counts the steps taken onto `steps`. False: a judge
  /// cannot carry the test out; `reason` says why.
  bool predict(const Test& test, int worker, std::span<TestPrediction> predictions, std::uint64_t& steps,
               std::string& reason) const;

 private:
  struct Judge {
    ModelProposal model;
    std::vector<double> moves = {};  ///< of each free value for its slope, in ranges; 0: it cannot move
    Eigen::MatrixXd information = {};
  };

  void find_information(const std::vector<ScoredTrial>& trials, Judge& judge);
  bool add_slopes(const TestPredictor& predictor, const Judge& judge, const Test& test, int worker,
                  TestPrediction& prediction, std::uint64_t& steps, std::string& reason) const;

  const EeaDefinition& definition_;
  std::vector<Judge> judges_;
  TestPredictor predictor_;
  std::vector<double> noise_;
  std::uint64_t steps_ = 0;
};

}  // namespace lacuna
