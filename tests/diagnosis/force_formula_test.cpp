#include "diagnosis/force_formula.h"

#include "diagnosis/free_force.h"
#include "diagnosis/synthetic_segments.h"

#include <gtest/gtest.h>

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
      folds.push_back(static_cast<std::size_t>(k * kFolds / kSegments));
    }
  }
  void add(const std::function<double(double, double)>& force) {
    for (std::size_t k = 0; k < segments.size(); ++k)
      for (Eigen::Index p = 0; p < 10; ++p)
        segments[k].residual += forces.of[k][0].col(p) * force(motion.position[k](p), motion.velocity[k](p));
  }
  std::vector<ForceFormula> formulas() const {
    return find_formulas(WhitenedSegments(noise, segments), {motion}, forces, folds, 1);
  }
  FreeForceTest free() const {
    return test_free_force(WhitenedSegments(noise, segments), free_force({motion}, forces), folds);
  }

  NoiseModel noise;
  SeededNoise random;
  ForceResponses forces = pushed_mass();
  JointMotion motion{"rail", 0, "m", "N", "", {}, {}, {}};
  std::vector<LinearSegment> segments;
  std::vector<std::size_t> folds;
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
  EXPECT_LT(free.p, 1e-6);
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
  EXPECT_LT(free.p, 1e-6);
  ASSERT_EQ(free.curves.size(), 5U);
  const ForceCurve &left = free.curves[2], &middle = free.curves[3], &right = free.curves[4];
  for (const ForceCurve* end : {&left, &right}) {
    ASSERT_TRUE(end->position);
    const double expected = kLaw * (*end->position * *end->position - *middle.position * *middle.position);
    EXPECT_NEAR(damping(*end) - damping(middle), expected, kTolerance * expected);
  }
}

TEST(FreeForce, IsUniformlyDistributedUnderNoise) {
  int alarms = 0;
  for (std::uint64_t seed = 100; seed < 160; ++seed) alarms += Rail(seed).free().p < 0.05;
  EXPECT_LE(alarms, 8);  // of 60 at 5 %, more in 1 % of cases
}

}  // namespace
}  // namespace lacuna::test
