#include "candidates/probe_sizes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kResidual = 5.0;  ///< of the model without the effect, in deviations of a reading
constexpr WantedChange kWanted{0.5, 1.0, false};

/// An effect with these values, which changes nothing at 0.
Hypothesis effect_with(const std::vector<FreeValue>& values) {
  Hypothesis hypothesis;
  hypothesis.entry.effect = "effect";
  hypothesis.definition.free = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    hypothesis.own.push_back(i);
    hypothesis.neutral.push_back(0.0);
  }
  hypothesis.defaults = hypothesis.neutral;
  return hypothesis;
}

FreeValue value_of(const std::string& name, const std::string& unit, double lower, double upper) {
  return {{"effect.effect." + name, unit, lower, upper, 0.0, Scale::linear}, ""};
}

/// Residuals of an effect that changes each prediction by this.
OwnResiduals changed_by(const std::function<double(const std::vector<double>&)>& change) {
  return [change](const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals) {
    residuals.assign(2, Eigen::VectorXd::Constant(10, kResidual - change(own)));
    return true;
  };
}

const SizedProbe* probe_of(const std::vector<SizedProbe>& probes, std::size_t sized) {
  const auto found =
      std::find_if(probes.begin(), probes.end(), [&](const SizedProbe& one) { return one.sized == sized; });
  return found == probes.end() ? nullptr : &*found;
}

/// 10 for each unit: half a unit changes predictions by as much as the residual.
TEST(SizeProbes, ChangeThePredictionsByAboutTheResidual) {
  for (const double gain : {10.0, 1e-3, 1e4}) {
    const std::vector<SizedProbe> probes =
        size_probes(effect_with({value_of("torque", "N*m", 0.0, 1e5)}),
                    changed_by([&](const std::vector<double>& own) { return gain * own[0]; }), kWanted, {});
    ASSERT_EQ(probes.size(), 1U) << gain;
    EXPECT_GE(gain * probes[0].own[0], 0.5 * kResidual) << gain;
    EXPECT_LE(gain * probes[0].own[0], 1.5 * kResidual) << gain;
    EXPECT_EQ(probes[0].sized, 0U);
    EXPECT_TRUE(probes[0].one_sided) << "nothing lies below 0";
  }
}

TEST(SizeProbes, MayHaveEitherSignWhereBothWaysAreOpen) {
  const std::vector<SizedProbe> probes =
      size_probes(effect_with({value_of("torque", "N*m", -10.0, 10.0)}),
                  changed_by([](const std::vector<double>& own) { return 10.0 * own[0]; }), kWanted, {});
  ASSERT_EQ(probes.size(), 1U);
  EXPECT_FALSE(probes[0].one_sided);
}

/// A limit that is out of reach above.
TEST(SizeProbes, GoDownWhereNothingChangesAbove) {
  const std::vector<SizedProbe> probes =
      size_probes(effect_with({value_of("limit", "N*m", -10.0, 10.0)}),
                  changed_by([](const std::vector<double>& own) { return 10.0 * std::min(own[0], 0.0); }), kWanted, {});
  ASSERT_EQ(probes.size(), 1U);
  EXPECT_LT(probes[0].own[0], 0.0);
  EXPECT_TRUE(probes[0].one_sided);
}

TEST(SizeProbes, TakeTheMostThatAnEffectCanDo) {
  const std::vector<SizedProbe> probes =
      size_probes(effect_with({value_of("torque", "N*m", 0.0, 2.0)}),
                  changed_by([](const std::vector<double>& own) { return 0.1 * own[0]; }), kWanted, {});
  ASSERT_EQ(probes.size(), 1U);
  EXPECT_EQ(probes[0].own[0], 2.0) << "a fraction of the residual, at the upper bound";
}

TEST(SizeProbes, AreNoneOfAnEffectThatChangesNothing) {
  EXPECT_TRUE(size_probes(effect_with({value_of("torque", "N*m", 0.0, 2.0)}),
                          changed_by([](const std::vector<double>&) { return 0.0; }), kWanted, {})
                  .empty());
}

TEST(SizeProbes, AreNoneWhereTheModelItselfCannotBeSimulated) {
  const OwnResiduals fails = [](const std::vector<double>&, std::vector<Eigen::VectorXd>&) { return false; };
  EXPECT_TRUE(size_probes(effect_with({value_of("torque", "N*m", 0.0, 2.0)}), fails, kWanted, {}).empty());
}

/// Beyond 0.1 the simulation fails.
TEST(SizeProbes, StayWhereTheEffectCanBeSimulated) {
  const OwnResiduals fragile = [](const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals) {
    residuals.assign(2, Eigen::VectorXd::Constant(10, kResidual - own[0]));
    return own[0] <= 0.1;
  };
  const std::vector<SizedProbe> probes =
      size_probes(effect_with({value_of("torque", "N*m", 0.0, 100.0)}), fragile, kWanted, {});
  ASSERT_EQ(probes.size(), 1U);
  EXPECT_GT(probes[0].own[0], 0.05);
  EXPECT_LE(probes[0].own[0], 0.1);
}

/// A foot leaves the ground at the smallest tilt.
TEST(SizeProbes, TakeAJumpOnlyWhereTheyMay) {
  const Hypothesis tilt = effect_with({value_of("tilt", "rad", 0.0, 1.0)});
  const OwnResiduals jumps =
      changed_by([](const std::vector<double>& own) { return own[0] > 0.0 ? 100.0 + own[0] : 0.0; });
  EXPECT_TRUE(size_probes(tilt, jumps, kWanted, {}).empty());
  EXPECT_EQ(size_probes(tilt, jumps, {0.5, 1.0, true}, {}).size(), 1U);
}

/// A mass on the axis does nothing, nor does a place without a mass.
TEST(SizeProbes, MoveTwoValuesTogetherThatDoNothingAlone) {
  const std::vector<SizedProbe> probes =
      size_probes(effect_with({value_of("mass", "kg", 0.0, 10.0), value_of("angle", "rad", -3.0, 3.0)}),
                  changed_by([](const std::vector<double>& own) { return 100.0 * own[0] * own[1]; }), kWanted, {});
  ASSERT_FALSE(probes.empty());
  for (const SizedProbe& probe : probes) {
    EXPECT_NE(probe.own[0], 0.0);
    EXPECT_NE(probe.own[1], 0.0);
  }
}

TEST(SizeProbes, SizeEachValueThatMattersByItself) {
  const std::vector<SizedProbe> probes = size_probes(
      effect_with({value_of("torque", "N*m", 0.0, 10.0), value_of("damping", "N*m*s/rad", 0.0, 10.0)}),
      changed_by([](const std::vector<double>& own) { return 10.0 * own[0] + 20.0 * own[1]; }), kWanted, {});
  ASSERT_NE(probe_of(probes, 0), nullptr);
  ASSERT_NE(probe_of(probes, 1), nullptr);
  EXPECT_EQ(probe_of(probes, 0)->own[1], 0.0);
  EXPECT_EQ(probe_of(probes, 1)->own[0], 0.0);
}

TEST(SizeProbes, TryTheDefaultsAsTheyAre) {
  Hypothesis hypothesis = effect_with({value_of("torque", "N*m", 0.0, 10.0)});
  hypothesis.defaults = {3.0};
  const std::vector<SizedProbe> probes =
      size_probes(hypothesis, changed_by([](const std::vector<double>& own) { return 10.0 * own[0]; }), kWanted, {});
  EXPECT_TRUE(
      std::any_of(probes.begin(), probes.end(), [](const SizedProbe& one) { return !one.sized && one.own[0] == 3.0; }));
}

/// The speed of Stribeck's curve is tried at 2 % and at 20 % of the usual one.
TEST(SizeProbes, TryAShapeAtWhatTheDataSuggest) {
  Hypothesis hypothesis = effect_with({value_of("torque", "N*m", 0.0, 10.0), value_of("speed", "rad/s", 0.001, 100.0)});
  hypothesis.neutral[1] = hypothesis.defaults[1] = 3.0;
  const std::vector<SizedProbe> probes = size_probes(
      hypothesis, changed_by([](const std::vector<double>& own) { return 10.0 * own[0]; }), kWanted, {{"rad/s", 5.0}});
  std::vector<double> speeds;
  for (const SizedProbe& probe : probes) speeds.push_back(probe.own[1]);
  EXPECT_THAT(speeds, testing::UnorderedElementsAre(3.0, testing::DoubleEq(0.1), testing::DoubleEq(1.0)));
}

}  // namespace
}  // namespace lacuna
