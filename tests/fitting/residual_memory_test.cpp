#include "fitting/shooting/residual_memory.h"

#include "fitting/made_problem.h"
#include "fitting/numerics/correlation_time.h"
#include "fitting/numerics/seeded_noise.h"

#include <gtest/gtest.h>

#include <vector>

namespace lacuna::residual_memory_test {
namespace {

using namespace lacuna::analytic;

constexpr double kRate = 20.0;  // Hz

double nothing(std::span<const double>, double) { return 0.0; }
Trial still(double duration) { return formula_trial(nothing, {}, duration, kRate, 0.1, 1); }

/// Residuals each of which keeps `memory` of the one before.
Eigen::VectorXd remembering(double memory, Eigen::Index size) {
  SeededNoise random(3, 3);
  Eigen::VectorXd residuals = Eigen::VectorXd::Zero(size);
  for (Eigen::Index i = 1; i < size; ++i) residuals(i) = memory * residuals(i - 1) + random.normal();
  return residuals;
}

double together(const Eigen::VectorXd& residuals) {
  return correlation_samples({residuals.data(), static_cast<std::size_t>(residuals.size())});
}

TEST(ResidualMemory, IsTheLongestTimeAndTheSumOfIndependentSamples) {
  const MadeProblem made = formula_problem(nothing, {}, {still(50.0), still(25.0)});
  const Eigen::VectorXd slow = remembering(0.8, 1001), white = remembering(0.0, 501);
  const ResidualMemory memory = residual_memory(made.problem, {slow, white});
  EXPECT_GT(together(slow), 5.0);
  EXPECT_DOUBLE_EQ(memory.time, together(slow) / kRate);
  EXPECT_DOUBLE_EQ(memory.effective_samples, 1001.0 / together(slow) + 501.0);
}

TEST(ResidualMemory, GoesOnFromSegmentToSegment) {
  const MadeProblem whole = formula_problem(nothing, {}, {still(50.0)}),
                    cut = formula_problem(nothing, {}, {still(50.0)}, 0.5);
  ASSERT_EQ(cut.problem.segments().size(), 100U);
  const Eigen::VectorXd slow = remembering(0.8, 1001);
  std::vector<Eigen::VectorXd> parts;
  for (const Segment& segment : cut.problem.segments())
    parts.emplace_back(slow.segment(segment.stretch.first, segment.stretch.size()));
  const ResidualMemory one = residual_memory(whole.problem, {slow}), other = residual_memory(cut.problem, parts);
  EXPECT_DOUBLE_EQ(other.time, one.time);
  EXPECT_DOUBLE_EQ(other.effective_samples, one.effective_samples);
}

TEST(ResidualMemory, LeavesOutPriors) {
  MadeProblem made = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  std::vector<Eigen::VectorXd> residuals = made.residuals_at({0.5});
  const ResidualMemory memory = residual_memory(made.problem, residuals);
  for (std::size_t k = 0; k < residuals.size(); ++k) residuals[k].tail(2).setConstant(1e3);
  EXPECT_EQ(residual_memory(made.problem, residuals).effective_samples, memory.effective_samples);
}

TEST(ResidualMemory, IsOfOneSampleAtTheLeast) {
  const MadeProblem made = formula_problem(nothing, {}, {still(1.0)});
  EXPECT_EQ(residual_memory(made.problem, {}).effective_samples, 1.0);
}

}  // namespace
}  // namespace lacuna::residual_memory_test
