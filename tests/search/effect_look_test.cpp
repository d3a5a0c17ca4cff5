#include "search/effect_look.h"

#include "prediction/whitened_columns.h"
#include "residual_law/pendulum_data.h"
#include "search/recorded_arm.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kDry = 0.04;          // N·m, of the recordings
constexpr double kRounding = 1e-9;     // nats
constexpr double kOfBounds = 0.01;     // nats, precision of the least cost within bounds
constexpr std::size_t kOfALook = 400;  // samples per length
const std::string kFriction = "coulomb_friction @ joint.hinge";

/// Nats of a pendulum with an effect, simulated on the stretches of a look with the initial states' derivatives of the
/// model as it is.
class SimulatedCost {
 public:
  SimulatedCost(const SearchData& data, const FittedModel& model)
      : data_(data), model_(model), ladder_(thinned(data.deciding(), kOfALook)) {
    const ModelContext context = data.bench_for(model.model);
    LadderPredictions predictions(ladder_, context.predictor(), context.space(), data.starts());
    linear_ =
        *predictions.linearise(predictions.at_smoothed_starts(context.space().to_coordinates(model.model.values)));
  }

  double of(const Hypothesis& hypothesis, const NamedValues& values) const {
    const ModelContext context(hypothesis.definition, *hypothesis.model, data_.task().trials, data_.timing(), {1},
                               kCommandsMayAct);
    LadderPredictions predictions(ladder_, context.predictor(), context.space(), data_.starts());
    const Eigen::VectorXd at = context.space().to_coordinates(all_values(hypothesis, values));
    std::vector<LinearStretch> stretches = linear_.stretches;
    EXPECT_TRUE(predictions.residuals_at(predictions.at_smoothed_starts(at), stretches));
    const BlockProducts products = whitened_products(ladder_, stretches);
    return cost_at(ladder_.layout, products, Eigen::VectorXd::Zero(products.values())).cost;
  }

  /// With the model's values as they are and its probe.
  double of_probe(const Hypothesis& hypothesis, const SizedProbe& probe) const {
    NamedValues values = model_.values;
    const std::vector<std::string> names = hypothesis.own_names();
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i]] = probe.own[i];
    return of(hypothesis, values);
  }

 private:
  std::vector<double> all_values(const Hypothesis& hypothesis, const NamedValues& values) const {
    std::vector<double> of_model, of_effect;
    for (const FreeValue& free : model_.model.definition.free) of_model.push_back(values.at(free.address));
    for (const std::string& name : hypothesis.own_names()) of_effect.push_back(values.at(name));
    std::vector<double> all = hypothesis.values(of_model, of_effect);
    all.push_back(values.at("timing"));
    return all;
  }

  const SearchData& data_;
  const FittedModel& model_;
  const PredictionLadder ladder_;
  LinearPrediction linear_;
};

/// The library beside the fitted model of a pendulum that has dry friction.
class EffectLookTest : public testing::Test {
 protected:
  EffectLookTest() { models_.fit({}, std::vector<NamedValues>(1)); }

  const FittedModel& base() const { return models_.base(); }
  const SearchData& data() const { return pendulum_.data(); }
  EffectLook look() const { return look_at_library(data(), base(), models_.ladder()); }
  static std::string name(const EffectLook& look, const EffectPromise& promise) {
    return member_name(look.hypotheses[promise.hypothesis].entry);
  }
  const FittedModel& friction() {
    EffectEntry entry;
    entry.effect = "coulomb_friction";
    entry.where = {"joint.hinge"};
    return *models_.fit({entry}, {{{kFriction + ".torque", 0.01}}});
  }

  const PendulumData pendulum_{
      two_recordings({.damping = 0.02, .friction = kDry}),
      {.among = {"torque_gain", "coulomb_friction", "joint_spring", "joint_offset_torque", "sensor_offset"}}};
  KeptFits kept_;
  FittedModels models_{pendulum_.data(), pendulum_.data().deciding(), kept_};
};

TEST_F(EffectLookTest, PromisesTheHiddenEffectFirst) {
  const EffectLook one = look();
  ASSERT_FALSE(one.promises.empty());
  EXPECT_EQ(name(one, one.promises.front()), kFriction);
  const auto falls = [](const EffectPromise& a, const EffectPromise& b) { return a.cost < b.cost; };
  EXPECT_TRUE(std::is_sorted(one.promises.begin(), one.promises.end(), falls));
  EXPECT_NEAR(one.cost, base().fit.cost, 0.05) << "the model itself, on fewer stretches";
}

/// A friction of 40 mN·m is predicted to first order alone.
TEST_F(EffectLookTest, PromisesAboutTheSizeThatIsHidden) {
  const EffectLook one = look();
  const EffectPromise& friction = one.promises.front();
  ASSERT_EQ(friction.probes.size(), 1U);
  const double size = friction.step(friction.step.size() - 1) * friction.probes.front().own.front();
  EXPECT_NEAR(size, kDry, 0.5 * kDry);
}

TEST_F(EffectLookTest, PromisesNoHigherCostThanThatOfTheModel) {
  const EffectLook one = look();
  EXPECT_EQ(one.promises.size(), one.hypotheses.size());
  for (const EffectPromise& promise : one.promises) EXPECT_LE(promise.cost, one.cost + kOfBounds) << name(one, promise);
}

/// Friction acts throughout the recordings, so what it gains on data to which it was not fitted is told nearly
/// everywhere.
TEST_F(EffectLookTest, TellsTheGainByBlockOfTime) {
  const EffectLook one = look();
  const Eigen::VectorXd& gains = one.promises.front().gains;
  ASSERT_EQ(gains.size(), static_cast<Eigen::Index>(data().deciding().layout.blocks()));
  EXPECT_GT(gains.sum(), 0.8 * (one.cost - one.promises.front().cost));
  EXPECT_GE((gains.array() > 0.0).count(), 9 * gains.size() / 10);
  EXPECT_GE(one.gains.size(), one.promises.size()) << "of every law";
}

TEST_F(EffectLookTest, BesideTheSameModelGivesTheSamePromises) {
  const EffectLook once = look(), again = look_beside(data(), base(), once);
  EXPECT_EQ(again.cost, once.cost);
  ASSERT_EQ(again.promises.size(), once.promises.size());
  for (std::size_t i = 0; i < once.promises.size(); ++i) {
    EXPECT_EQ(name(again, again.promises[i]), name(once, once.promises[i]));
    EXPECT_EQ(again.promises[i].cost, once.promises[i].cost);
    EXPECT_EQ(again.promises[i].step, once.promises[i].step);
    EXPECT_EQ(again.promises[i].gains, once.promises[i].gains);
  }
}

TEST_F(EffectLookTest, BesideTheHiddenEffectPromisesLittle) {
  const EffectLook before = look(), beside = look_beside(data(), friction(), before);
  for (const EffectPromise& promise : beside.promises) {
    EXPECT_NE(name(beside, promise), kFriction) << "is there";
    EXPECT_LT(promise.gains.sum(), 0.05 * before.promises.front().gains.sum()) << name(beside, promise);
  }
  EXPECT_LT(beside.cost, before.promises.front().cost + 0.05);
}

TEST_F(EffectLookTest, BeginsAFitNoHigherThanAtTheSmallestProbe) {
  const EffectLook one = look();
  const SimulatedCost simulated(data(), base());
  for (const EffectPromise& promise : one.promises) {
    const Hypothesis& hypothesis = one.hypotheses[promise.hypothesis];
    if (promise.probes.size() > 1) continue;
    const NamedValues start = start_of_fit(data(), base(), one, promise);
    EXPECT_LE(simulated.of(hypothesis, start), simulated.of_probe(hypothesis, promise.probes.front()) + kRounding)
        << name(one, promise);
  }
}

/// The step of the model's own values, which had absorbed the friction, is part of the start.
TEST_F(EffectLookTest, BeginsAFitOfTheHiddenEffectNearItsEnd) {
  const EffectLook one = look();
  const SimulatedCost simulated(data(), base());
  const Hypothesis& hypothesis = one.hypotheses[one.promises.front().hypothesis];
  const NamedValues start = start_of_fit(data(), base(), one, one.promises.front());
  const double gain = one.cost - one.promises.front().cost;
  EXPECT_GT(one.cost - simulated.of(hypothesis, start), 0.5 * gain);
  EXPECT_LT(start.at("joint.hinge.damping"), base().values.at("joint.hinge.damping"));
}

/// The distance over which a hysteresis turns is tried at a few values, each of which is a law. The promise is that of
/// the best.
TEST(EffectLookOfLaws, PromisesTheBestLawOfAnEffect) {
  const PendulumData pendulum(two_recordings({.damping = 0.02, .friction = kDry}), {.among = {"hysteresis"}});
  KeptFits kept;
  FittedModels models(pendulum.data(), pendulum.data().deciding(), kept);
  models.fit({}, std::vector<NamedValues>(1));
  const EffectLook look = look_at_library(pendulum.data(), models.base(), models.ladder());
  ASSERT_EQ(look.promises.size(), 1U);
  std::vector<double> gains;
  for (const Eigen::VectorXd& law : look.gains) gains.push_back(law.sum());
  ASSERT_GT(gains.size(), 1U);
  const auto [least, most] = std::minmax_element(gains.begin(), gains.end());
  EXPECT_LT(*least, 0.5 * *most) << testing::PrintToString(gains);
  EXPECT_GT(look.promises.front().gains.sum(), 0.95 * *most) << testing::PrintToString(gains);
}

/// Each of four joints has a value of its own, so the promise is that of all joints together.
TEST(EffectLookAtManyJoints, PromisesAnEffectOnEveryJointWithAValueForEach) {
  const ArmData arm({0.03, 0.03, 0.03, 0.03});
  KeptFits kept;
  FittedModels models(arm.data(), arm.data().deciding(), kept);
  models.fit({}, std::vector<NamedValues>(1));
  const EffectLook look = look_at_library(arm.data(), models.base(), models.ladder());
  ASSERT_EQ(look.promises.size(), 5U) << "on each joint, and on all";
  const EffectPromise& every = look.promises.front();
  const Hypothesis& hypothesis = look.hypotheses[every.hypothesis];
  EXPECT_EQ(hypothesis.where(), "joint.*");
  ASSERT_EQ(every.probes.size(), 4U);
  for (std::size_t joint = 0; joint < 4; ++joint)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(every.probes[joint].own[i] != hypothesis.neutral[i], i == joint) << "the probe of joint " << joint;
}

Hypothesis one_at(const std::string& effect, const std::string& place, std::vector<std::string> alike = {}) {
  Hypothesis one;
  one.entry.effect = effect;
  one.entry.where = {place};
  one.alike = std::move(alike);
  return one;
}

TEST(OfOneKind, AreAnEffectAndThoseThatEitherDeclaresAlikeAtOnePlace) {
  const Hypothesis dry = one_at("dry", "joint.a", {"sticky"}), sticky = one_at("sticky", "joint.a");
  EXPECT_TRUE(of_one_kind(dry, dry));
  EXPECT_TRUE(of_one_kind(dry, sticky));
  EXPECT_TRUE(of_one_kind(sticky, dry)) << "whoever declares it";
  EXPECT_FALSE(of_one_kind(sticky, one_at("spring", "joint.a")));
  EXPECT_FALSE(of_one_kind(dry, one_at("dry", "joint.b"))) << "at another place";
  EXPECT_FALSE(of_one_kind(dry, one_at("sticky", "joint.b")));
}

}  // namespace
}  // namespace lacuna
