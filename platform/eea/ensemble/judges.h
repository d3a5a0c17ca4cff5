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

/// Models that judge tests, with the information of the trials so far on the sensors' noise and, where the experiment's
/// test fitness needs it, on the models' free values. Const and shared by threads, each with its own worker.
class Judges {
 public:
  /// The ensemble of the state's last estimation phase, as many models as the test fitness takes. Definition and state
  /// must outlive it.
  Judges(const EeaDefinition& definition, const Work& work, const EeaState& state);

  std::size_t size() const { return judges_.size(); }
  int workers() const { return predictor_.workers(); }
  /// Taken to evaluate the trials.
  std::uint64_t steps() const { return steps_; }
  /// Fills one prediction per judge, reusing memory, and adds the steps taken to `steps`. False: a judge cannot carry
  /// the test out; `reason` says why.
  bool predict(const Test& test, int worker, std::span<TestPrediction> predictions, std::uint64_t& steps,
               std::string& reason) const;

 private:
  struct Judge {
    ModelProposal model;
    std::vector<double> moves = {};  ///< step of each free value for its slope, in ranges; 0: it cannot move
    Eigen::MatrixXd information = {};
  };

  void find_information(const std::vector<ScoredTrial>& trials, Judge& judge);
  bool add_slopes(const TestPredictor& predictor, const Judge& judge, const Test& test, int worker,
                  TestPrediction& prediction, std::uint64_t& steps, std::string& reason) const;

  const EeaDefinition& definition_;
  Stop stop_;
  std::vector<Judge> judges_;
  TestPredictor predictor_;
  std::vector<double> noise_;
  std::uint64_t steps_ = 0;
};

}  // namespace lacuna
