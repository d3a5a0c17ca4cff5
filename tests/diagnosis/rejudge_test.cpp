#include "diagnosis/rounds/rejudge.h"

#include "diagnosis/pendulum_rounds.h"
#include "diagnosis/rounds/ranking.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kFriction = 0.02;  ///< N·m, hidden

std::size_t rival_of(const Round& round, const std::string& effect) {
  const auto found = std::find_if(round.rivals.begin(), round.rivals.end(), [&](const Rival& rival) {
    return round.hypotheses[rival.hypothesis].entry.effect == effect;
  });
  return static_cast<std::size_t>(found - round.rivals.begin());
}

/// A pendulum with dry friction, for which drag was taken first.
class RejudgedFriction : public PendulumRounds {
 protected:
  Round round_of(const Contender& contender) {
    return PendulumRounds::round_of(contender, {.inertia = 0.03, .damping = 0.02, .friction = kFriction},
                                    {"coulomb_friction", "quadratic_drag"});
  }
};

TEST_F(RejudgedFriction, IsBetterAfterAllAndGoesOnFromWhereItWasRefitted) {
  const Round first = round_of(model_);
  ASSERT_EQ(first.rivals.size(), 2U);
  const std::size_t friction = rival_of(first, "coulomb_friction"), drag = rival_of(first, "quadratic_drag");
  SearchStep step = step_of(model_, first, drag);
  const Contender wrong = with_effect_of(step.rivals[drag], step, model_, built_catalog());
  const Round now = round_of(wrong);
  step.rivals[friction].values.back() = 0.5 * kFriction;

  const Rejudged again = rejudge({step, model_, built_catalog(), now, 1, 2});
  ASSERT_EQ(again.better, friction);
  ASSERT_EQ(again.values.size(), step.rivals[friction].values.size());
  EXPECT_NEAR(again.values.back(), kFriction, 0.05 * kFriction);
}

/// A little more friction on the way back is less than a tenth of what an effect gains that gains twenty times as
/// much as here, and beyond all noise.
TEST_F(RejudgedFriction, GoesToTheRicherOneThatAloneReachesTheFloor) {
  const PendulumTruth truth = {.inertia = 0.03, .damping = 0.02, .friction = kFriction, .backward = 0.02 * kFriction};
  const std::vector<std::string> among = {"coulomb_friction", "directional_friction"};
  const Round first = PendulumRounds::round_of(model_, truth, among);
  const std::size_t plain = rival_of(first, "coulomb_friction"), by_direction = rival_of(first, "directional_friction");
  SearchStep step = step_of(model_, first, plain);
  for (KeptRival& rival : step.rivals) rival.gain.value *= 20.0;
  const Contender simple = with_effect_of(step.rivals[plain], step, model_, built_catalog());
  const Round now = PendulumRounds::round_of(simple, truth, among);

  const RejudgeTask task{step, model_, built_catalog(), now, 1, 2};
  const Eigen::VectorXd richer = held_out_deviance(refit_again(task, {by_direction}).at(0).fit, now.folds);
  ASSERT_LT(gain(now.held_out, richer, 1).value, 0.1 * step.rivals[plain].gain.value);
  EXPECT_EQ(rejudge(task).better, by_direction);
}

}  // namespace
}  // namespace lacuna
