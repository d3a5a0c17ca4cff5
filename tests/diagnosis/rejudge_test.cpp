#include "diagnosis/rejudge.h"

#include "diagnosis/pendulum_rounds.h"
#include "diagnosis/ranking.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kFriction = 0.02;  ///< N·m, hidden

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
  const auto of = [&](const std::string& effect) {
    const auto found = std::find_if(first.rivals.begin(), first.rivals.end(), [&](const Rival& rival) {
      return first.hypotheses[rival.hypothesis].entry.effect == effect;
    });
    return static_cast<std::size_t>(found - first.rivals.begin());
  };
  const std::size_t friction = of("coulomb_friction"), drag = of("quadratic_drag");
  SearchStep step = step_of(model_, first, drag);
  const Contender wrong = with_effect_of(step.rivals[drag], step, model_, built_catalog());
  const Round now = round_of(wrong);
  step.rivals[friction].values.back() = 0.5 * kFriction;

  const Rejudged again = rejudge({step, model_, built_catalog(), now, 1, 2});
  ASSERT_EQ(again.better, friction);
  ASSERT_EQ(again.values.size(), step.rivals[friction].values.size());
  EXPECT_NEAR(again.values.back(), kFriction, 0.05 * kFriction);
}

}  // namespace
}  // namespace lacuna
