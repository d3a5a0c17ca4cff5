#include "runs/carried_out_test.h"

#include "hand_made_case.h"
#include "support/test_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr std::size_t kSamples = 101;

MadeCase pendulum(const CaseNoise& noise) { return pendulum_case({{"coulomb_friction", 0, {0.05}}}, noise, kSamples); }

/// The commands of a case's first trial, as the program would write them.
std::string csv_of(const MadeCase& made) {
  std::string text = "t [s],motor [N*m]\n";
  const Excitation& applied = made.trials.front().applied;
  for (std::size_t k = 0; k < applied.samples(); ++k)
    text += fmt::format("{},{}\n", 0.005 * static_cast<double>(k), applied.commands[0][k]);
  return text;
}

double root_mean_square(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

class CarriedOutTest : public testing::Test {
 protected:
  MadeTrial carry_out(const MadeCase& made, std::uint64_t seed) const {
    return carried_out_test(made, folder_.write("commands.csv", csv_of(made)), seed);
  }
  lacuna::TestFolder folder_;
};

/// White noise of 0.5 mrad; a hundred samples tell its size to 7 %, and steps of 0.25 ms to 25 µs differ far less.
TEST_F(CarriedOutTest, ReadsWhatATrialOfTheSameCommandsReadsButForNoise) {
  const MadeCase made = pendulum(white_noise());
  const MadeTrial trial = carry_out(made, 3);
  ASSERT_EQ(trial.readings[0].size(), kSamples);
  EXPECT_LT(root_mean_square(trial.clean[0], made.trials[0].clean[0]), 1e-5);
  EXPECT_NEAR(root_mean_square(trial.readings[0], trial.clean[0]), 5e-4, 1.5e-4);
  EXPECT_EQ(trial.recorded_commands, trial.applied.commands);
}

TEST_F(CarriedOutTest, HasNoiseOfItsSeed) {
  const MadeCase made = pendulum(disturbed_noise());
  const MadeTrial one = carry_out(made, 3), same = carry_out(made, 3), other = carry_out(made, 4);
  EXPECT_EQ(one.readings, same.readings);
  EXPECT_EQ(one.recorded_commands, same.recorded_commands);
  EXPECT_NE(one.readings, other.readings);
  EXPECT_NE(one.recorded_commands, other.recorded_commands);
  EXPECT_NE(one.recorded_commands, one.applied.commands);
  EXPECT_EQ(one.clean, other.clean);
}

TEST_F(CarriedOutTest, RefusesFilesThatAreNoCommands) {
  const PlantSpec spec = servo_pendulum().nominal;
  for (const char* text : {"", "t [s],motor [N*m]\n0,0.1\n", "t [s],servo [rad]\n0,0.1\n0.005,0.1\n",
                           "t [s],motor [N*m]\n0,0.1\n0.007,0.1\n", "t [s],motor [N*m]\n0,0.1\n0.005\n",
                           "t [s],motor [N*m]\n0,0.1\n0.005,much\n"})
    EXPECT_THROW(read_commands(folder_.write("commands.csv", text), spec, 0.005), std::runtime_error) << text;
}

}  // namespace
}  // namespace hidden_effects
