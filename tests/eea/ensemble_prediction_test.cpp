#include "eea/ensemble/ensemble_prediction.h"

#include "eea/small_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

/// Models of the last pass of a small run, whose tests are controllers.
class EnsemblePredictionTest : public testing::Test {
 protected:
  EnsemblePredictionTest()
      : opened_(small_bench({"estimation.restarts=3", "estimation.ensemble=3"})), journal_(run(*opened_)) {
    const PassRow& pass = journal_.passes.back();
    ensemble_.pass = pass.number;
    for (const EnsembleRow& row : pass.ensemble)
      add_unless_copy(ensemble_, row.model, definition().decode_model(journal_.models.at(row.model).genome),
                      definition().phenotypes);
    std::uint64_t steps = 0;
    ensemble_.noise = noise_of_readings(definition(), ensemble_.models.front(), {observed(0)}, steps);
  }

  const EeaDefinition& definition() const { return opened_->definition(); }
  ScoredTrial observed(std::size_t trial) const {
    const std::uint64_t test = *journal_.trial_rows.at(trial).test;
    return definition().observed(definition().decode_test(journal_.tests.at(test).genome), journal_.trials.at(trial));
  }
  EnsemblePrediction predict(int threads) const {
    return predict_test(definition(), ensemble_, as_carried_out(observed(0)), definition().sample_times, {threads});
  }

  std::unique_ptr<OpenEeaRun> opened_;
  MemoryJournal journal_;
  PassEnsemble ensemble_;
};

TEST_F(EnsemblePredictionTest, LetsTheControllerDriveEachModel) {
  ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const Controller>>(observed(0).test.drive));
  ASSERT_GE(ensemble_.models.size(), 2U);
  const EnsemblePrediction prediction = predict(1);
  EXPECT_EQ(prediction.models, ensemble_.models.size());
  EXPECT_EQ(prediction.band.mean.rows(), static_cast<Eigen::Index>(definition().sample_times.size()));
  PassEnsemble first = ensemble_;
  first.models.resize(1);
  const EnsemblePrediction alone =
      predict_test(definition(), first, as_carried_out(observed(0)), definition().sample_times, {1});
  EXPECT_GT((prediction.band.half_width - alone.band.half_width).maxCoeff(), 0.0) << "models differ in what they do";
  EXPECT_EQ(predict(2).band.half_width, prediction.band.half_width);
}

TEST_F(EnsemblePredictionTest, HoldsATrialThatIsNewAgainstTheBand) {
  const HeldOutTrial held_out = held_against(definition(), ensemble_, 2, observed(2));
  ASSERT_EQ(held_out.ratios.size(), definition().compiled->channels().size());
  for (const std::vector<double>& ratios : held_out.ratios) EXPECT_EQ(ratios.size(), definition().sample_times.size());
}

TEST_F(EnsemblePredictionTest, CountsModelsThatCannotCarryTheTestOut) {
  ensemble_.models[0].values.assign(ensemble_.models[0].values.size(), std::numeric_limits<double>::quiet_NaN());
  const EnsemblePrediction prediction = predict(1);
  ASSERT_EQ(prediction.lost.size(), 1U);
  EXPECT_EQ(prediction.lost[0].number, ensemble_.numbers[0]);
  EXPECT_FALSE(prediction.lost[0].reason.empty());
  EXPECT_EQ(prediction.models, ensemble_.models.size() - 1);
  EXPECT_TRUE(prediction.band.mean.allFinite());
}

}  // namespace
}  // namespace lacuna
