#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <set>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kPeriod = 0.005;   // s, of control
constexpr double kDuration = 10.0;  // s
constexpr double kRounding = 1e-9;

enum Shape { kMultisine, kSteps, kChirp, kTriangle };

class CommandSeriesTest : public testing::Test {
 protected:
  CommandSeriesTest() {
    space_.sensors = {{"angle", "rad"}};
    space_.actuators = {{"motor", "N*m"}};
    space_.lower = {-0.5};
    space_.upper = {1.5};
    space_.control_period = kPeriod;
    space_.duration = kDuration;
    for (const ParameterDeclaration& declaration : encoding_.parameters())
      parameters_.push_back(declaration.default_value);
  }
  lacuna::Test decode(const Genome& genome) const { return encoding_.decode(space_, parameters_, genome); }
  Eigen::VectorXd commands(const Genome& genome) const {
    return std::get<CommandSeries>(decode(genome).drive).series.samples.col(0);
  }

  const TestEncoding& encoding_ = built_catalog().get<TestEncoding>("command_series");
  TestSpace space_;
  std::vector<double> parameters_;
};

/// Amplitude of a frequency in samples that hold a whole number of its periods.
double amplitude_at(const Eigen::VectorXd& samples, double frequency) {
  std::complex<double> sum = 0.0;
  for (Eigen::Index k = 0; k < samples.size(); ++k)
    sum += samples(k) * std::polar(1.0, -2.0 * std::numbers::pi * frequency * static_cast<double>(k) * kPeriod);
  return 2.0 * std::abs(sum) / static_cast<double>(samples.size());
}

TEST_F(CommandSeriesTest, MultisinesHaveEqualLinesInTheirBandAndNoOthers) {
  const Eigen::VectorXd samples = commands({kMultisine, 0.3, 0.1, 2.0, 0.5, 7.0});  // either order of the band
  EXPECT_NEAR((samples.array() - 0.1).abs().maxCoeff(), 0.3, kRounding);
  const Eigen::VectorXd about = samples.array() - 0.1;
  const double line = amplitude_at(about, 0.5);
  EXPECT_GT(line, 0.01);
  EXPECT_NEAR(amplitude_at(about, 2.0), line, kRounding);
  for (const double outside : {0.1, 0.4, 2.1, 5.0}) EXPECT_NEAR(amplitude_at(about, outside), 0.0, kRounding);
  EXPECT_NE(samples, commands({kMultisine, 0.3, 0.1, 0.5, 2.0, 8.0})) << "another seed, other phases";
}

TEST_F(CommandSeriesTest, ABandWithoutAMultipleIsOneSine) {
  const Eigen::VectorXd samples = commands({kMultisine, 0.3, 0.0, 0.12, 0.18, 1.0});
  const double frequency = std::sqrt(0.12 * 0.18);
  for (Eigen::Index k = 1; k + 1 < samples.size(); ++k)  // of every sine: x(k-1) + x(k+1) = 2 cos(w h) x(k)
    ASSERT_NEAR(samples(k - 1) + samples(k + 1),
                2.0 * std::cos(2.0 * std::numbers::pi * frequency * kPeriod) * samples(k), kRounding);
}

TEST_F(CommandSeriesTest, StepsHoldEachLevelForAPeriod) {
  const Eigen::VectorXd samples = commands({kSteps, 0.4, 0.0, 2.0, 2.0, 3.0});
  std::set<double> levels;
  constexpr Eigen::Index kHeld = 100;  // samples of half a second
  for (Eigen::Index k = 0; k < samples.size(); ++k) {
    EXPECT_EQ(samples(k), samples(k - k % kHeld)) << k;
    levels.insert(samples(k));
  }
  EXPECT_EQ(levels.size(), 20U);
  EXPECT_NEAR(samples.cwiseAbs().maxCoeff(), 0.4, kRounding);
}

TEST_F(CommandSeriesTest, AChirpSweepsItsBandExponentially) {
  const Eigen::VectorXd samples = commands({kChirp, 0.4, 0.0, 0.5, 4.0, 0.0});
  const double growth = std::log(8.0);
  for (Eigen::Index k = 0; k < samples.size(); ++k) {
    const double t = static_cast<double>(k) * kPeriod;
    const double periods = 0.5 * kDuration * (std::exp(growth * t / kDuration) - 1.0) / growth;
    ASSERT_NEAR(samples(k), 0.4 * std::sin(2.0 * std::numbers::pi * periods), kRounding) << t;
  }
  const Eigen::VectorXd plain = commands({kChirp, 0.4, 0.0, 0.5, 0.5, 0.0});
  EXPECT_NEAR(amplitude_at(plain, 0.5), 0.4, kRounding) << "a band of one frequency is a sine";
}

TEST_F(CommandSeriesTest, ATriangleGoesStraightUpAndDown) {
  const Eigen::VectorXd samples = commands({kTriangle, 0.4, 0.2, 0.25, 0.25, 0.0});
  EXPECT_NEAR(samples(0), 0.2, kRounding);
  EXPECT_NEAR(samples(200), 0.6, kRounding) << "a quarter of a period";
  EXPECT_NEAR(samples(600), -0.2, kRounding);
  for (Eigen::Index k = 1; k < samples.size(); ++k)
    ASSERT_NEAR(std::abs(samples(k) - samples(k - 1)), 4.0 * 0.4 * 0.25 * kPeriod, kRounding) << k;
}

TEST_F(CommandSeriesTest, NoGenomeLeavesTheLimits) {
  const GenomeLayout layout = encoding_.layout(space_, parameters_);
  for (std::uint64_t key = 0; key < 300; ++key) {
    RandomStream random(std::vector<std::uint64_t>{key});
    Genome genome = encoding_.random(layout, random);
    for (std::size_t i = 0; i < genome.size(); ++i)  // and corners of the layout
      if (key % 3 == 1 && layout.genes[i].kind == GeneKind::real)
        genome[i] = random.chance(0.5) ? layout.genes[i].lower : layout.genes[i].upper;
    const Eigen::VectorXd samples = commands(genome);
    EXPECT_GE(samples.minCoeff(), -0.5);
    EXPECT_LE(samples.maxCoeff(), 1.5);
  }
  EXPECT_NEAR(commands({kTriangle, 1.0, -0.3, 1.0, 1.0, 0.0}).minCoeff(), -0.5, kRounding) << "less amplitude instead";
}

TEST_F(CommandSeriesTest, LastsAndUpdatesAsItsParametersSay) {
  parameters_[4] = 2.0;   // duration
  parameters_[5] = 0.05;  // interval
  const lacuna::Test test = decode({kTriangle, 0.4, 0.0, 1.0, 1.0, 0.0});
  const CommandSeries& series = std::get<CommandSeries>(test.drive);
  EXPECT_EQ(test.duration, 2.0);
  EXPECT_EQ(series.hold, Hold::zero_order);
  ASSERT_EQ(series.series.times.size(), 40);
  EXPECT_NEAR(series.series.times(1), 0.05, kRounding);
}

TEST_F(CommandSeriesTest, SaysWhatItCannotDrive) {
  parameters_[3] = 60.0;
  EXPECT_THAT([&] { encoding_.layout(space_, parameters_); }, ThrowsMessage<Error>(HasSubstr("50")));
  parameters_[3] = 0.01;
  EXPECT_THAT([&] { encoding_.layout(space_, parameters_); }, ThrowsMessage<Error>(HasSubstr("exchange")));
  space_.upper[0] = kInfinity;
  EXPECT_THAT([&] { encoding_.layout(space_, parameters_); }, ThrowsMessage<Error>(HasSubstr("\"motor\"")));
}

}  // namespace
}  // namespace lacuna
