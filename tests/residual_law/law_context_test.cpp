#include "residual_law/law_context.h"

#include "fitting/numerics/seeded_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kStretches = 40;
constexpr Eigen::Index kPulsesOfStretch = 10;

/// Stretches in which a force moves only the reading beside it, by 1 for a unit: the residual is the force. The start
/// is exact. Each stretch is a block of time, each fourth one a fold.
struct DirectForces {
  PredictionLadder ladder;
  LinearPrediction linear;
  StepBounds bounds;
  JointCourse course{"hinge", "rad", "N*m", "", {{}}};
  ForcePulses pulses;

  /// `force`: on the joint, by its moment; noise has a deviation of 1. `covered`: samples that a pulse covers.
  explicit DirectForces(const std::function<double(const JointMoment&)>& force, Eigen::Index covered = 1) {
    SeededNoise random(11, 0);
    ladder.lengths = {1.0};
    ladder.noise = {{"angle", "rad", 1.0, ""}};
    ladder.layout = {{{0, 1.0}}, 1, {}, 4};
    const Eigen::Index samples = covered * kPulsesOfStretch;
    for (std::size_t k = 0; k < kStretches; ++k) {
      ladder.layout.fold_of_block.push_back(k % 4);
      PredictedStretch& stretch = ladder.stretches.emplace_back();
      stretch.stretch = {0, static_cast<Eigen::Index>(k) * samples, static_cast<Eigen::Index>(k + 1) * samples + 1};
      stretch.covariance.resize(0, 0);
      LinearStretch& of_model = linear.stretches.emplace_back();
      of_model.residual.resize(kPulsesOfStretch);
      of_model.values.resize(kPulsesOfStretch, 0);
      of_model.start.resize(kPulsesOfStretch, 0);
      auto& covers = pulses.samples.emplace_back();
      for (Eigen::Index p = 0; p < kPulsesOfStretch; ++p) {
        double mean = 0.0;
        for (Eigen::Index i = 0; i < covered; ++i) {
          course.trials[0].push_back({.position = random.normal(), .velocity = random.normal()});
          mean += force(course.trials[0].back()) / static_cast<double>(covered);
        }
        of_model.residual(p) = mean + random.normal();
        covers.emplace_back(p * covered, (p + 1) * covered);
        stretch.rows.push_back((p + 1) * covered);
        stretch.columns.push_back(0);
        stretch.channels.push_back(0);
        stretch.blocks.push_back(k);
      }
      pulses.responses.push_back(Eigen::MatrixXd::Identity(kPulsesOfStretch, kPulsesOfStretch));
    }
  }

  /// Laws of the position and of the velocity; needs this.
  LawContext context() const& {
    return {
        ladder, linear,
        bounds, course,
        pulses, {[](const JointMoment& at) { return at.position; }, [](const JointMoment& at) { return at.velocity; }}};
  }
};

/// 400 readings tell a coefficient to about a twentieth.
constexpr double kFourErrors = 0.2;

TEST(LawContextTest, FindsTheSizeOfTheForce) {
  const DirectForces forces([](const JointMoment& at) { return 2.0 * at.position; });
  const LawContext context = forces.context();
  const FittedLaw law = context.fit("both", {0, 1}, 0.0);
  ASSERT_EQ(context.sizes(law).size(), 2);
  EXPECT_NEAR(context.sizes(law)(0), 2.0, kFourErrors);
  EXPECT_NEAR(context.sizes(law)(1), 0.0, kFourErrors);
}

TEST(LawContextTest, KnowsHowWellItIsTold) {
  const DirectForces forces([](const JointMoment& at) { return 2.0 * at.position; });
  const LawContext context = forces.context();
  const Eigen::MatrixXd covariance = context.covariance(context.fit("", {0}, 0.0));
  ASSERT_EQ(covariance.size(), 1);
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), 1.0 / std::sqrt(400.0), 0.02);
}

/// Mean squares of 4 + 1 become 1: half the logarithm of five.
TEST(LawContextTest, GainsTheLogarithmOfWhatTheForceExplains) {
  const DirectForces forces([](const JointMoment& at) { return 2.0 * at.position; });
  const LawContext context = forces.context();
  const FittedLaw law = context.fit("position", {0}, 0.0), plain = context.fit("", {}, 0.0);
  EXPECT_NEAR(plain.fit.mean_square(0), 5.0, 0.7);
  EXPECT_NEAR(law.fit.mean_square(0), 1.0, 0.2);
  EXPECT_NEAR(gain_of(law.judged, plain.judged).nats, 0.5 * std::log(5.0), 0.1);
  EXPECT_EQ(law.judged.members, std::set<std::string>{"position"});
}

TEST(LawContextTest, GainsNothingFromAnotherQuantity) {
  const DirectForces forces([](const JointMoment& at) { return 2.0 * at.position; });
  const LawContext context = forces.context();
  EXPECT_LT(gain_of(context.fit("velocity", {1}, 0.0).judged, context.fit("", {}, 0.0).judged).nats, 0.01);
}

/// A ridge of 1 on one function halves it.
TEST(LawContextTest, ShrinksTheForceByTheRidge) {
  const DirectForces forces([](const JointMoment& at) { return 2.0 * at.position; });
  const LawContext context = forces.context();
  const std::vector<double> ridges = {0.0, 1.0};
  const std::vector<FittedLaw> laws = context.fits("position", {0}, ridges);
  ASSERT_EQ(laws.size(), 2U);
  EXPECT_EQ(laws[1].ridge, 1.0);
  EXPECT_NEAR(context.sizes(laws[1])(0), 0.5 * context.sizes(laws[0])(0), 1e-9);
}

TEST(LawContextTest, TakesTheMeanOfAFunctionOverAPulse) {
  const DirectForces forces([](const JointMoment& at) { return 3.0 * at.velocity; }, 4);
  const LawContext context = forces.context();
  EXPECT_NEAR(context.sizes(context.fit("", {1}, 0.0))(0), 3.0, 2.0 * kFourErrors) << "four times the spread of one";
}

/// What a value of the model explains as well is left to both.
TEST(LawContextTest, FitsTheModelsValuesWithinTheirBoundsBesideTheForce) {
  DirectForces forces([](const JointMoment& at) { return 2.0 * at.position + 1.0 * at.velocity; });
  for (std::size_t k = 0; k < kStretches; ++k) {
    Eigen::MatrixXd& values = forces.linear.stretches[k].values;
    values.resize(kPulsesOfStretch, 1);
    for (Eigen::Index p = 0; p < kPulsesOfStretch; ++p)
      values(p, 0) = forces.course.trials[0][k * kPulsesOfStretch + static_cast<std::size_t>(p)].velocity;
  }
  forces.bounds.lower = Eigen::VectorXd::Constant(1, -0.25);
  forces.bounds.upper = Eigen::VectorXd::Constant(1, 0.25);
  const LawContext context = forces.context();
  const FittedLaw law = context.fit("", {0}, 0.0);
  ASSERT_EQ(law.fit.step.size(), 2);
  EXPECT_EQ(law.fit.step(0), 0.25) << "1 would be right, and is beyond the bound";
  EXPECT_NEAR(context.sizes(law)(0), 2.0, kFourErrors);
}

}  // namespace
}  // namespace lacuna
