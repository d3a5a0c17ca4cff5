#include "diagnosis/rounds/deeper_minimum.h"

#include "diagnosis/pendulum_rounds.h"

#include <gtest/gtest.h>

#include <optional>

namespace lacuna {
namespace {

/// A pendulum with dry friction that its model lacks, and a round that has looked for it.
class DeeperMinimum : public PendulumRounds {
 protected:
  const PendulumTruth truth_ = {.inertia = 0.03, .damping = 0.02, .friction = 0.02};
  std::optional<Round> round_ = round_of(model_, truth_, {"coulomb_friction"});
};

TEST_F(DeeperMinimum, IsNotWhatAnEffectExplains) {
  ASSERT_GT(round_->rivals.at(0).gain.value, 100.0);
  EXPECT_FALSE(deeper_minimum(model_, *round_, 2));
}

/// As where the model's own fit had ended beside its minimum, and an effect's had not.
TEST_F(DeeperMinimum, IsFoundFromWhereAnEffectEnded) {
  const Refit at_minimum = round_->fit;
  const double explained = at_minimum.deviance - round_->rivals.at(0).fit.deviance;
  round_->fit.deviance += 10.0 * explained;
  for (double& value : round_->fit.values) value *= 1.5;
  const std::optional<Refit> deeper = deeper_minimum(model_, *round_, 2);
  ASSERT_TRUE(deeper);
  EXPECT_NEAR(deeper->deviance, at_minimum.deviance, 0.01 * explained);
  for (std::size_t i = 0; i < at_minimum.values.size(); ++i)
    EXPECT_NEAR(deeper->values[i], at_minimum.values[i], 0.01 * at_minimum.values[i]);
}

}  // namespace
}  // namespace lacuna
