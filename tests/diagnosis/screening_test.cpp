#include "diagnosis/screening/screening.h"

#include "diagnosis/synthetic_segments.h"

#include <gtest/gtest.h>

namespace lacuna::test {
namespace {

/// White noise of deviation 1 with twelve probes that overlap, and three values.
struct Screened {
  explicit Screened(std::uint64_t seed) : noise(one_channel(), {}) {
    std::vector<double> white(noise.components().size(), 0.0);
    white.front() = 1.0;
    noise.set_deviations(white);
    SeededNoise random(seed, 1);
    probes.resize(6, std::vector<Probe>(2));
    for (int k = 0; k < kSegments; ++k) {
      segments.push_back({normal(kRows, 1, random), normal(kRows, 3, random), free_start()});
      const Eigen::MatrixXd common = normal(kRows, 1, random);
      for (auto& of : probes)
        for (Probe& probe : of) probe.response.emplace_back(common + normal(kRows, 1, random));
    }
  }
  Screening screen() const { return lacuna::screen(WhitenedSegments(noise, segments), probes, 5); }
  NoiseModel noise;
  std::vector<LinearSegment> segments;
  std::vector<std::vector<Probe>> probes;
};

TEST(Screening, RaisesAFalseAlarmInFivePercentOfNoise) {
  int alarms = 0;
  constexpr int kRepetitions = 200;
  for (int seed = 0; seed < kRepetitions; ++seed)
    alarms += Screened(static_cast<std::uint64_t>(seed)).screen().p <= 0.05;
  EXPECT_GE(alarms, 3);  // of 200 at 5 %, fewer in 1 % of cases
  EXPECT_LE(alarms, 18);
}

TEST(Screening, FindsTheProbeThatIsInTheResidual) {
  Screened case_(1);
  for (int k = 0; k < kSegments; ++k)
    case_.segments[static_cast<std::size_t>(k)].residual +=
        0.5 * case_.probes[4][1].response[static_cast<std::size_t>(k)];
  const Screening found = case_.screen();
  EXPECT_EQ(found.scores.front().hypothesis, 4U);
  EXPECT_EQ(found.scores.front().probe, 1U);
  EXPECT_NEAR(found.scores.front().size, 0.5, 0.1);
  EXPECT_GT(found.scores.front().deviance, found.chance_95);
  EXPECT_LT(found.p, 0.001);
}

TEST(Screening, GivesNoCreditForAnEffectOfTheWrongSign) {
  Screened case_(2);
  for (int k = 0; k < kSegments; ++k)
    case_.segments[static_cast<std::size_t>(k)].residual -= case_.probes[3][0].response[static_cast<std::size_t>(k)];
  for (auto& of : case_.probes)
    for (Probe& probe : of) probe.one_sided = true;
  EXPECT_LT(case_.screen().scores.front().deviance, 20.0);
}

/// What the model's values explain is not there to be seen.
TEST(Screening, LeavesOutWhatTheModelCanTakeUp) {
  Screened case_(3);
  for (std::size_t k = 0; k < static_cast<std::size_t>(kSegments); ++k)
    case_.probes[2][0].response[k] = case_.segments[k].values.col(1);
  for (const ProbeScore& score : case_.screen().scores) EXPECT_FALSE(score.hypothesis == 2 && score.probe == 0);
}

}  // namespace
}  // namespace lacuna::test
