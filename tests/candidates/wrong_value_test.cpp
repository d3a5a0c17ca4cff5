#include "candidates/wrong_value.h"

#include "config/experiment_reader.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace lacuna {
namespace {

class WrongValueTest : public testing::Test {
 protected:
  WrongValueTest() : experiment_(read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml")) {}

  std::vector<std::string> addresses() const {
    std::vector<std::string> all;
    for (const EffectEntry& entry : wrong_values(define_model(experiment_, built_catalog())))
      all.push_back(entry.where.front());
    return all;
  }

  Experiment experiment_;
};

TEST_F(WrongValueTest, AreTheFixedNumbersThatTheRobotFileStates) {
  const std::vector<std::string> all = addresses();
  EXPECT_THAT(all, testing::Contains("body.arm.com.z"));
  EXPECT_THAT(all, testing::Contains("body.arm.inertia.yy"));
  EXPECT_THAT(all, testing::Not(testing::Contains("joint.hinge.armature"))) << "it is free";
  EXPECT_THAT(all, testing::Not(testing::Contains("actuator.motor.gain"))) << "1 states nothing";
  EXPECT_THAT(all, testing::Not(testing::Contains("sensor.angle.noise")));
  EXPECT_THAT(all, testing::Not(testing::Contains("world.gravity.z")));
}

TEST_F(WrongValueTest, IsFittedWithinATenthAndTenTimesWhereItIsPositive) {
  const ModelDefinition base = define_model(experiment_, built_catalog());
  const std::vector<EffectEntry> entries = wrong_values(base);
  const auto inertia = std::find_if(entries.begin(), entries.end(), [](const EffectEntry& entry) {
    return entry.where.front() == "body.arm.inertia.yy";
  });
  ASSERT_NE(inertia, entries.end());
  const ModelDefinition freed = define_model(with_free_value(experiment_, *inertia), built_catalog());
  const auto value = std::find_if(freed.free.begin(), freed.free.end(),
                                  [&](const FreeValue& free) { return belongs_to(free, *inertia); });
  ASSERT_NE(value, freed.free.end());
  EXPECT_EQ(freed.free.size(), base.free.size() + 1);
  EXPECT_DOUBLE_EQ(value->lower, value->start / 10.0);
  EXPECT_DOUBLE_EQ(value->upper, value->start * 10.0);
}

TEST_F(WrongValueTest, MayChangeItsSignWhereThatIsPossible) {
  const std::vector<EffectEntry> entries = wrong_values(define_model(experiment_, built_catalog()));
  const auto com = std::find_if(entries.begin(), entries.end(),
                                [](const EffectEntry& entry) { return entry.where.front() == "body.arm.com.z"; });
  ASSERT_NE(com, entries.end());
  const auto& [lower, upper] = com->range.at("z");
  EXPECT_LT(lower, 0.0);
  EXPECT_GT(upper, 0.0);
}

}  // namespace
}  // namespace lacuna
