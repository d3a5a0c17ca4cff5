#include "diagnosis/residual_force/force_formula.h"

#include "diagnosis/linear_refit.h"
#include "diagnosis/residual_force/free_force.h"
#include "diagnosis/screening/screening.h"
#include "diagnosis/synthetic_segments.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include <numbers>

namespace lacuna::test {
namespace {

constexpr int kFolds = 8;

/// A mass on a rail with white readings of deviation 1, which a force law moves that the model does not have.
struct Rail {
  explicit Rail(std::uint64_t seed) : noise(one_channel(), {}), random(seed, 3) {
    std::vector<double> white(noise.components().size(), 0.0);
    white.front() = 1.0;
    noise.set_deviations(white);
    for (int k = 0; k < kSegments; ++k) {
      motion.position.emplace_back(normal(10, 1, random));
      motion.velocity.emplace_back(2.0 * normal(10, 1, random));
      segments.push_back({normal(kRows, 1, random), normal(kRows, 2, random), free_start()});
      folds.push_back({static_cast<std::size_t>(k * kFolds / kSegments)});
    }
  }
  void add(const std::function<double(double, double)>& force) {
    for (std::size_t k = 0; k < segments.size(); ++k)
      for (Eigen::Index p = 0; p < 10; ++p)
        segments[k].residual += forces.of[k][0].col(p) * force(motion.position[k](p), motion.velocity[k](p));
  }
  std::vector<ForceFormula> formulas() const {
    const Refit fit = linear_refit(noise, segments);
    const std::vector<Eigen::MatrixXd> factors = noise_factors(noise);
    return find_formulas({fit, factors, folds, 1}, {motion}, forces);
  }
  FreeForceTest free() const {
    const Refit fit = linear_refit(noise, segments);
    const std::vector<Eigen::MatrixXd> factors = noise_factors(noise);
    return test_free_force({fit, factors, folds, 1}, WhitenedSegments(noise, segments), free_force({motion}, forces));
  }

  NoiseModel noise;
  SeededNoise random;
  ForceResponses forces = pushed_mass();
  JointMotion motion{"rail", 0, "m", "N", "", {}, {}, {}};
  std::vector<LinearSegment> segments;
  Folds folds;
};

TEST(ForceFormula, FindsTheLawThatMovedTheMass) {
  Rail rail(1);
  rail.add([](double q, double v) { return -0.3 * v * std::abs(v) + 0.5 * q * q * q; });
  const std::vector<ForceFormula> found = rail.formulas();
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found.front().terms.size(), 2U) << found.front().text();
  for (const ForceFormula::Term& term : found.front().terms) {
    const double truth = term.text == "v*abs(v)" ? -0.3 : 0.5;
    EXPECT_TRUE(term.text == "v*abs(v)" || term.text == "q^3") << term.text;
    EXPECT_NEAR(term.coefficient, truth, 4.0 * term.standard_error);
    EXPECT_LT(term.standard_error, 0.1 * std::abs(truth));
  }
  EXPECT_GT(found.front().gain.lower_95, 0.0);
}

/// The rail's model with the force of some law as a value that is fitted.
Refit with_law(const Rail& rail, const std::function<double(double, double)>& law) {
  std::vector<LinearSegment> longer = rail.segments;
  for (std::size_t k = 0; k < longer.size(); ++k) {
    longer[k].values.conservativeResize(Eigen::NoChange, 3);
    longer[k].values.col(2).setZero();
    for (Eigen::Index p = 0; p < 10; ++p)
      longer[k].values.col(2) -=
          rail.forces.of[k][0].col(p) * law(rail.motion.position[k](p), rail.motion.velocity[k](p));
  }
  return linear_refit(rail.noise, longer);
}

/// Far above the noise, too, where the loss of the fits is not that of least squares: a formula, a refit of a model
/// with the same law and a free force are told in the same nats.
TEST(HeldOutDeviance, OfFormulaRefitAndFreeForceIsOne) {
  constexpr double kFar = 10.0;
  Rail rail(4);
  const auto drag = [](double, double v) { return v * std::abs(v); };
  rail.add([&](double q, double v) { return -3.0 * drag(q, v); });
  for (LinearSegment& segment : rail.segments) segment.residual += kFar * normal(kRows, 1, rail.random);  // no force
  const Eigen::VectorXd plain = held_out_deviance(linear_refit(rail.noise, rail.segments), rail.folds);
  const Eigen::VectorXd refit = held_out_deviance(with_law(rail, drag), rail.folds);
  const double gained = gain(plain, refit, 1).value;
  const std::vector<ForceFormula> found = rail.formulas();
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found.front().terms.size(), 1U) << found.front().text();
  EXPECT_NEAR(found.front().gain.value, gained, 1e-3 * gained);
  EXPECT_NEAR(gain(plain, rail.free().held_out, 1).value, gained, 0.05 * gained);
}

TEST(ForceFormula, FindsNothingInNoise) {
  int found = 0;
  for (std::uint64_t seed = 10; seed < 40; ++seed) found += static_cast<int>(Rail(seed).formulas().size());
  EXPECT_LE(found, 2);  // of 30
}

TEST(ForceFormula, WritesTheForceAsAText) {
  ForceFormula formula{"hinge", "N*m", {{"v*abs(v)", "rad^2/s^2", -0.0213, 0.001}, {"1", "1", 0.4, 0.01}}, {}};
  EXPECT_EQ(formula.text(), "-0.0213*v*abs(v) + 0.4");
}

TEST(FreeForce, DrawsTheForceAndRefutesChance) {
  Rail rail(2);
  rail.add([](double, double v) { return v > 0.0 ? -1.0 : 1.0; });
  const FreeForceTest free = rail.free();
  EXPECT_EQ(free.p, 1.0 / (1.0 + kNullDraws));
  ASSERT_EQ(free.curves.size(), 5U);  // and three slices
  const ForceCurve& by_velocity = free.curves[1];
  EXPECT_EQ(by_velocity.of, "velocity");
  // A constant may stand in either curve: the step from fast backward to fast forward is what is told.
  EXPECT_NEAR(by_velocity.force.back() - by_velocity.force.front(), -2.0, 0.5);
}

/// The damping on a slice: minus the slope of its force over velocity, by least squares.
double damping(const ForceCurve& slice) {
  double mean = 0.0, sum = 0.0, squares = 0.0;
  for (const double v : slice.at) mean += v / static_cast<double>(slice.at.size());
  for (std::size_t i = 0; i < slice.at.size(); ++i) {
    sum += (slice.at[i] - mean) * slice.force[i];
    squares += (slice.at[i] - mean) * (slice.at[i] - mean);
  }
  return -sum / squares;
}

TEST(FreeForce, TellsDampingThatDependsOnThePosition) {
  constexpr double kLaw = 0.5, kTolerance = 0.2;  // N*s/m^3; the values of the model take some of it
  Rail rail(3);
  rail.add([](double q, double v) { return -kLaw * q * q * v; });
  const FreeForceTest free = rail.free();
  EXPECT_EQ(free.p, 1.0 / (1.0 + kNullDraws));
  ASSERT_EQ(free.curves.size(), 5U);
  const ForceCurve &left = free.curves[2], &middle = free.curves[3], &right = free.curves[4];
  for (const ForceCurve* end : {&left, &right}) {
    ASSERT_TRUE(end->position);
    const double expected = kLaw * (*end->position * *end->position - *middle.position * *middle.position);
    EXPECT_NEAR(damping(*end) - damping(middle), expected, kTolerance * expected);
  }
}

/// A random force that changes within a second and pushes a mass that goes slowly to and fro. The noise model has a
/// third of it, of its own correlation time, and segments that know nothing of each other: what a force of any form
/// could explain was taken for structure when the noise was estimated.
Rail pushed_at_random(std::uint64_t seed) {
  constexpr double kDeviation = 0.5, kTime = 1.0, kPeriod = 5.0, kStroke = 1.0;
  Rail rail(seed);
  rail.noise = NoiseModel(one_channel(), rail.forces);
  std::vector<double> deviations(rail.noise.components().size(), 0.0);
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (rail.noise.components()[i].kind == NoiseComponent::Kind::sensor) deviations[i] = 1.0;
    if (rail.noise.components()[i].kind == NoiseComponent::Kind::slow_force) deviations[i] = kDeviation / 3.0;
  }
  rail.noise.set_deviations(deviations);
  const double interval = rail.forces.width, keep = std::exp(-interval / kTime);
  double force = kDeviation * rail.random.normal(), time = 0.0;
  const double turn = 2.0 * std::numbers::pi / kPeriod;
  for (std::size_t k = 0; k < rail.segments.size(); ++k)
    for (Eigen::Index p = 0; p < 10; ++p, time += interval) {
      rail.motion.position[k](p) = kStroke * std::sin(turn * time);
      rail.motion.velocity[k](p) = kStroke * turn * std::cos(turn * time);
      rail.segments[k].residual += rail.forces.of[k][0].col(p) * force;
      force = keep * force + std::sqrt(1.0 - keep * keep) * kDeviation * rail.random.normal();
    }
  return rail;
}

TEST(FreeForce, IsNotSureOfASlowRandomForce) {
  int alarms = 0, sure = 0, sure_if_noise_were_known = 0;
  for (std::uint64_t seed = 200; seed < 230; ++seed) {
    const FreeForceTest free = pushed_at_random(seed).free();
    alarms += free.p < 0.05;
    sure += free.p < 0.001;
    const boost::math::chi_squared chance(free.freedom);
    sure_if_noise_were_known += boost::math::cdf(boost::math::complement(chance, free.deviance)) < 0.001;
  }
  EXPECT_LE(alarms, 5);  // of 30 at 5 %, more in 1 % of cases
  EXPECT_LE(sure, 1);
  EXPECT_GE(sure_if_noise_were_known, 20);
}

TEST(FreeForce, IsUniformlyDistributedUnderNoise) {
  int alarms = 0;
  for (std::uint64_t seed = 100; seed < 160; ++seed) alarms += Rail(seed).free().p < 0.05;
  EXPECT_LE(alarms, 8);  // of 60 at 5 %, more in 1 % of cases
}

}  // namespace
}  // namespace lacuna::test
