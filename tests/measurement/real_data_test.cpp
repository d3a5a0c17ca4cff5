#include "measurement/recording.h"

#include "measurement/rest_noise.h"

#include "measurement_fixture.h"

#include <cmath>
#include <cstdlib>

namespace lacuna {
namespace {

/// Recordings that are not part of the project; LACUNA_DATA says where they are.
class RealData : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("LACUNA_DATA");
    if (!folder) GTEST_SKIP() << "LACUNA_DATA is not set";
    data_ = folder;
  }

  static ColumnMapping column(const std::string& channel, const std::string& name, const std::string& unit) {
    ColumnMapping mapping;
    mapping.channel = channel;
    mapping.column = name;
    mapping.unit = unit;
    return mapping;
  }

  std::filesystem::path data_;
};

TEST_F(RealData, ReadsEmps) {
  RecordingSource source;
  source.time_column = "t_s";
  source.files = {{.path = data_ / "emps/test_pulses.csv", .held_out = true}, {.path = data_ / "emps/train.csv"}};
  source.sensors = {column("position", "qm_m", "m")};
  source.commands = {column("drive", "vir_V", "V")};
  source.commands[0].gain = 35.15065;
  source.commands[0].gain_unit = "N/V";
  const Recording recording = read_recording(source, {{"position", "m"}}, {{"drive", "N"}});
  ASSERT_EQ(recording.trials.size(), 2u);
  const Trial& train = recording.trials[0];
  EXPECT_EQ(train.name, "train.csv");
  EXPECT_EQ(train.measured.times.size(), 24841);
  EXPECT_EQ(train.measured.samples(1, 0), 1.43e-5);
  EXPECT_DOUBLE_EQ(train.commands.series.samples(0, 0), 2.53862809 * 35.15065);
  EXPECT_FALSE(train.measured.samples.hasNaN());
  EXPECT_TRUE(recording.trials[1].held_out);
  // The carriage never stands still, and 50 nm is the last digit printed.
  EXPECT_TRUE(std::isnan(estimate_sensor_noise(recording.trials, "position").standard_deviation));
  EXPECT_EQ(recording.notes.size(), 0u) << notes_of(recording);
}

TEST_F(RealData, ReadsThePendulum) {
  RecordingSource source;
  source.time_column = "t_s";
  source.files = {{.path = data_ / "dfki_pendulum/ddp.csv"},
                  {.path = data_ / "dfki_pendulum/direct_collocation.csv", .held_out = true}};
  source.sensors = {column("angle", "theta_rad", "rad"), column("rate", "theta_dot_rad_s", "rad/s")};
  source.commands = {column("motor", "tau_Nm", "N*m")};
  const Recording recording = read_recording(source, kPendulumChannels, kPendulumActuators);
  ASSERT_EQ(recording.trials.size(), 2u);
  EXPECT_EQ(recording.trials[0].measured.times.size(), 3000);
  EXPECT_EQ(recording.trials[1].measured.times.size(), 1170);
  EXPECT_EQ(recording.trials[0].measured.samples(1, 1), -0.0769231);
  EXPECT_EQ(recording.notes.size(), 0u) << notes_of(recording);

  // The encoder's step is the reason for the 0.84 mrad that such rigs are quoted with; the measured
  // velocity is far noisier than its own step of 22 mrad/s.
  const SensorNoise angle = estimate_sensor_noise(recording.trials, "angle");
  EXPECT_NEAR(angle.quantum, 2.914e-3, 0.002e-3);
  EXPECT_NEAR(angle.standard_deviation, 0.841e-3, 0.001e-3);
  const SensorNoise rate = estimate_sensor_noise(recording.trials, "rate");
  EXPECT_NEAR(rate.quantum, 0.02198, 0.0001);
  EXPECT_GT(rate.standard_deviation, 0.1);
  EXPECT_LT(rate.standard_deviation, 0.2);
}

}  // namespace
}  // namespace lacuna
