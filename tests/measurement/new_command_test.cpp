#include "new_command_fixture.h"

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(NewCommand, DraftsTheServoPendulum) {
  const std::filesystem::path data = std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "experiments/data/servo_pendulum";
  const Outcome outcome = run_new({data / "sine.csv", data / "steps.csv", data / "chirp.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("column angle_deg in deg (the unit in its name)"));
  EXPECT_THAT(outcome.out, HasSubstr("chirp.csv (the last file)"));
  EXPECT_THAT(outcome.out, HasSubstr("rig-robot.toml:8  mass = \"FILL IN kg\"\n"));
  EXPECT_THAT(text_of(rig()), HasSubstr("noise: step 3.07 mrad/√12"));  // 2048 counts a turn
  const Recording recording = expect_a_draft_that_works();
  ASSERT_EQ(recording.trials.size(), 3u);
  EXPECT_TRUE(recording.trials[2].held_out);
  EXPECT_NEAR(recording.trials[0].sensor_noise[0], 2.0 * 3.14159265 / 2048.0 / std::sqrt(12.0), 1e-5);
}

TEST_F(NewCommand, DraftsSeveralJointsWithoutUnitsInOneFileOfTrials) {
  std::string text = "run;time;q1;q2;dq1;tau1;tau2\n";
  for (int i = 0; i < 300; ++i)
    text += fmt::format("{};{};{:.4f};{:.4f};{:.4f};{:.3f};{:.3f}\n", i / 100 + 1, 5 * (i % 100), std::sin(0.1 * i),
                        std::cos(0.1 * i), std::cos(0.1 * i), std::sin(0.07 * i), std::cos(0.05 * i));
  const Outcome outcome = run_new({folder_.write("runs.csv", text)});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("joint2_motor     column tau2 (its name)"));
  const Recording recording = expect_a_draft_that_works();
  ASSERT_EQ(recording.trials.size(), 3u);
  EXPECT_EQ(recording.trials[2].name, "runs.csv[3]");
  EXPECT_TRUE(recording.trials[2].held_out);
  EXPECT_EQ(recording.trials[0].measured.channels.size(), 3u);
}

TEST_F(NewCommand, SaysThatCommasAreBothDecimalSignsAndDelimiters) {
  std::string text = "t_s,angle_deg,torque_Nm\n0,0,0\n";
  for (int i = 1; i < 50; ++i) text += fmt::format("0,{:02},{},{:02},-1,{:02}\n", i, i % 7, i % 100, (7 * i) % 100);
  const Outcome outcome = run_new({folder_.write("run.csv", text)});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("run.csv:3: 6 cells where the header (line 1) has 3 names"));
  EXPECT_THAT(outcome.err, HasSubstr("semicolons or tabs (0,01;0,5)"));
}

/// A pendulum that was let go: nothing is held between its samples.
TEST_F(NewCommand, SaysNothingOfHoldingWithoutCommands) {
  std::string text = "t_s,angle_rad\n";
  for (int i = 0; i < 200; ++i) text += fmt::format("{},{:.5f}\n", 0.01 * i, std::cos(0.05 * i));
  const Outcome outcome = run_new({folder_.write("run.csv", text)});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("hold ")));
  EXPECT_THAT(text_of(rig()), Not(HasSubstr("hold =")));
  EXPECT_TRUE(expect_a_draft_that_works().trials[0].commands.series.channels.empty());
}

TEST_F(NewCommand, DraftsAServo) {
  std::string text = "t,angle_deg,angle_ref_deg\n";
  for (int i = 0; i < 100; ++i)
    text += fmt::format("{},{},{}\n", 0.01 * i, 40.0 * std::sin(0.1 * i), 45.0 * std::sin(0.11 * i));
  ASSERT_EQ(run_new({folder_.write("run.csv", text)}).code, 0);
  EXPECT_THAT(text_of(robot()), HasSubstr("kind = \"position_servo\""));
  EXPECT_EQ(expect_a_draft_that_works().trials[0].commands.series.channels[0].unit, "rad");
}

/// An angle, what it was to follow, and a torque that `command` makes of step and error in rad.
template <class Command>
std::string controlled(const Command& command) {
  std::string text = "t_s,angle_deg,angle_ref_deg,torque_Nm\n";
  for (int i = 0; i < 300; ++i) {
    const double angle = 0.7 * std::sin(0.1 * i), wanted = 0.8 * std::sin(0.1 * i + 0.2);
    const double degrees = 180.0 / 3.141592653589793;
    text += fmt::format("{},{:.6f},{:.6f},{:.6f}\n", 0.01 * i, degrees * angle, degrees * wanted,
                        command(i, wanted - angle));
  }
  return text;
}

TEST_F(NewCommand, DraftsTheLawOfAController) {
  const std::string text = controlled([](int, double error) { return 2.5 * error; });
  ASSERT_EQ(run_new({folder_.write("run.csv", text)}).code, 0);
  EXPECT_THAT(text_of(rig()), HasSubstr("# motor = { reads = \"angle\", reference = { column = \"angle_ref_deg\", unit "
                                        "= \"deg\" }, proportional = \"2.5 N*m/rad\" }\n"));
  std::string stated =
      std::regex_replace(text_of(rig()), std::regex("# \\[target.controllers\\]"), "[target.controllers]");
  stated = std::regex_replace(stated, std::regex("# motor = "), "motor = ");
  std::ofstream(rig()) << stated;
  const Recording recording = expect_a_draft_that_works();
  EXPECT_NE(recording.trials[0].controller, nullptr);
}

TEST_F(NewCommand, LeavesGainsBlankThatDoNotMakeTheCommand) {
  const std::string text = controlled([](int i, double) { return std::sin(0.37 * i); });
  ASSERT_EQ(run_new({folder_.write("run.csv", text)}).code, 0);
  EXPECT_THAT(text_of(rig()), HasSubstr("gains explain these commands"));
  EXPECT_THAT(text_of(rig()), HasSubstr("proportional = \"FILL IN N*m/rad\" }"));
}

TEST_F(NewCommand, DraftsAVoltageOnAMotor) {
  std::string text = "t [s],angle [deg],motor voltage [V]\n";
  for (int i = 0; i < 100; ++i) text += fmt::format("{},{:.4f},{:.3f}\n", 0.01 * i, 40.0 * std::sin(0.1 * i), 0.1 * i);
  ASSERT_EQ(run_new({folder_.write("run.csv", text)}).code, 0);
  EXPECT_THAT(text_of(rig()), HasSubstr("motor = { column = \"motor voltage [V]\", unit = \"V\" }"));
  EXPECT_THAT(text_of(robot()), HasSubstr("kind = \"voltage\""));
  EXPECT_THAT(text_of(robot()), HasSubstr("torque_constant = \"FILL IN N*m/A\""));
  EXPECT_THAT(run({"check", rig().string()}).err, HasSubstr("resistance: is not filled in: write a resistance in Ohm"));
  EXPECT_EQ(expect_a_draft_that_works().trials[0].commands.series.channels[0].unit, "V");
}

TEST_F(NewCommand, AsksForTheGainOfAPotentiometer) {
  std::string text = "t_s,angle_V,tau_Nm\n";
  for (int i = 0; i < 100; ++i) text += fmt::format("{},{:.4f},{:.3f}\n", 0.01 * i, std::sin(0.1 * i), 0.1 * i);
  ASSERT_EQ(run_new({folder_.write("run.csv", text)}).code, 0);
  EXPECT_THAT(text_of(rig()), HasSubstr("angle = { column = \"angle_V\", unit = \"V\", gain = \"FILL IN rad/V\" }"));
  expect_a_draft_that_works();
}

/// As programs for schools export: every name ends in the run, a byte order mark, semicolons, decimal commas.
TEST_F(NewCommand, DraftsWhatEndsInARunsNumber) {
  std::string text = "\xef\xbb\xbf\"Time (s) Run #1\";\"Position (m) Run #1\";\"Velocity (m/s) Run #1\"\r\n";
  for (int i = 0; i < 100; ++i)
    text += fmt::format("0,{:03};0,{:02};{}\r\n", 10 * i % 1000, 40 + i % 7, i % 3 == 0 ? "" : "-0,25");
  const Outcome outcome = run_new({folder_.write("run.csv", text)});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("position         column Position (m) Run #1 in m (the unit in its name)"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("trials  ")));
  EXPECT_EQ(expect_a_draft_that_works().trials[0].measured.channels.size(), 2u);
}

TEST_F(NewCommand, LeavesBlanksOfWhichCheckSaysWhatIsWantedWithUnitAndExample) {
  std::string text = "t,q1,q2,i1_A,i2\n";
  for (int i = 0; i < 100; ++i) text += fmt::format("{},{:.4f},{:.4f},0.1,0.2\n", 0.01 * i, std::sin(0.1 * i), 0.1 * i);
  ASSERT_EQ(run_new({folder_.write("run.csv", text)}).code, 0);
  const Outcome check = run({"check", rig().string()});
  EXPECT_EQ(check.code, 2);
  for (const char* sentence :
       {"target.sensors.joint1_angle.unit: is not filled in: write the unit of the column, as in \"deg\", \"mm\"",
        "target.commands.joint1_motor.gain: is not filled in: write a torque per current in N*m/A, as in \"0.05",
        "body.joint1_link.mass: is not filled in: write a mass in kg, as in \"0.5 kg\"",
        "body.joint1_link.inertia[0]: is not filled in: write a moment of inertia in kg*m^2, as in \"0.002 kg*m^2\"",
        "joint.joint2.parent: is not filled in: write one of: world or joint1_link"})
    EXPECT_THAT(check.err, HasSubstr(sentence));
}

TEST_F(NewCommand, CountsOneTrialAsOne) {
  const Outcome outcome = run_new({folder_.write("run.csv", "t,angle_deg,tau_Nm\n0,1,2\n0.1,2,3\n0.2,1,2\n")});
  EXPECT_THAT(outcome.out, HasSubstr("written from 1 recording\n"));
  EXPECT_THAT(outcome.out, HasSubstr("10 Hz, 1 trial\n"));
}

TEST_F(NewCommand, NeverOverwrites) {
  const std::filesystem::path file = folder_.write("run.csv", "t,angle_deg,tau_Nm\n0,1,2\n0.1,2,3\n0.2,1,2\n");
  folder_.write("rig-robot.toml", "mine\n");
  EXPECT_THAT(run_new({file}).err, HasSubstr("rig-robot.toml: already exists and is not overwritten"));
  EXPECT_FALSE(std::filesystem::exists(rig()));
  std::filesystem::remove(robot());
  folder_.write("rig.toml", "mine\n");
  EXPECT_EQ(run_new({file}).code, 1);
  EXPECT_EQ(text_of(rig()), "mine\n");
  EXPECT_FALSE(std::filesystem::exists(robot()));
}

TEST_F(NewCommand, MatchesColumnsWithARobotThatIsThere) {
  const std::filesystem::path file =
      folder_.write("run.csv", "t,theta_deg,i_A,T_C\n0,1,2,20\n0.1,2,3,20\n0.2,1,2,20\n");
  folder_.write("mine.toml", kPivot);
  const Outcome outcome = run_new_of(file, "mine.toml");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  joint  robot channel   unit   file column  unit  matched by\n"
                                     "  pivot  sensor.encoder  rad    theta_deg    deg   the only column that fits\n"
                                     "  pivot  sensor.tacho    rad/s  -                  no column matches\n"
                                     "  pivot  actuator.drive  N*m    i_A          A     the only column that fits\n"));
  const std::string text = text_of(rig());
  for (const char* line : {"file = \"mine.toml\"", "encoder = { column = \"theta_deg\", unit = \"deg\" }",
                           "drive = { column = \"i_A\", unit = \"A\", gain = \"FILL IN N*m/A\" }",
                           "# not matched: tacho in rad/s, no column matches", "# \"body.rod.mass\""})
    EXPECT_THAT(text, HasSubstr(line));
  EXPECT_FALSE(std::filesystem::exists(robot()));
  fill(rig());
  const Outcome checked =
      run({"check", rig().string(), "--plugin-path", LACUNA_BINARY_DIRECTORY "/lib/lacuna/plugins"});
  EXPECT_EQ(checked.code, 0) << checked.err;
}

/// The pivot under a torque that swings it widely, its angle in counts of which a turn has `counts`.
std::string wide_swing(double counts) {
  constexpr double kInertia = 0.04, kGravity = 0.5 * 9.81 * 0.2, kInterval = 5e-3;
  constexpr int kSubsteps = 50;
  double q = 0.0, v = 0.0;
  std::string text = "t,u,pos\n";
  for (int i = 0; i < 1600; ++i) {
    const double t = kInterval * i, u = 0.6 * std::sin(4.0 * t) + 0.4 * std::sin(2.6 * t + 1.0);
    text += fmt::format("{:.3f},{:.6f},{:.0f}\n", t, u, q / (2.0 * M_PI) * counts);
    for (int k = 0; k < kSubsteps; ++k) {
      v += kInterval / kSubsteps * (u - kGravity * std::sin(q)) / kInertia;
      q += kInterval / kSubsteps * v;
    }
  }
  return text;
}

TEST_F(NewCommand, IsFollowedByACheckThatDoubtsCountsPerTurn) {
  folder_.write("mine.toml", kPivot);
  folder_.write("run.csv", wide_swing(1024.0));
  const auto notes_with = [&](int counts) {
    folder_.write("rig.toml", fmt::format(R"([experiment]
name = "counts"
[target]
kind = "recorded"
files = ["run.csv"]
holdout = []
[target.time]
column = "t"
[target.sensors]
encoder = {{ column = "pos", unit = "1", counts_per_turn = {} }}
[target.commands]
drive = {{ column = "u", unit = "N*m" }}
[model]
file = "mine.toml"
effects = []
[engine]
step = 0.005
)",
                                          counts));
    const Outcome checked =
        run({"check", rig().string(), "--plugin-path", LACUNA_BINARY_DIRECTORY "/lib/lacuna/plugins"});
    EXPECT_EQ(checked.code, 0) << checked.err;
    return checked.out;
  };
  EXPECT_THAT(notes_with(4096), HasSubstr("encoder = { ..., counts_per_turn = 1024 }"));
  EXPECT_THAT(notes_with(256), HasSubstr("encoder = { ..., counts_per_turn = 1024 }"));
  EXPECT_THAT(notes_with(1024), Not(HasSubstr("known forces")));
}

TEST_F(NewCommand, RefusesARobotThatIsNone) {
  const std::filesystem::path file = folder_.write("run.csv", "t,angle_deg,tau_Nm\n0,1,2\n0.1,2,3\n0.2,1,2\n");
  folder_.write("notes.txt", "mine\n");
  folder_.write("other.toml", "[experiment]\nname = \"other\"\n");
  const std::pair<const char*, const char*> kRefused[] = {
      {"nowhere.toml", "nowhere.toml: no such file"},
      {"notes.txt", "notes.txt: cannot be read as a robot file: its name ends with none of .mjcf, .toml, .urdf, .xml"},
      {"other.toml", "other.toml:1:2: --robot names an experiment file, not a robot file"}};
  for (const auto& [name, sentence] : kRefused) {
    const Outcome outcome = run_new_of(file, name);
    EXPECT_EQ(outcome.code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
    EXPECT_FALSE(std::filesystem::exists(rig()));
  }
}

TEST_F(NewCommand, NamesAFileWithoutSamples) {
  const Outcome outcome = run_new({folder_.write("run.csv", "t,angle_deg,tau_Nm\n")});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("run.csv:1: has a header but no samples"));
}

TEST_F(NewCommand, TellsProblemsOfTheRecordingsAndDraftsAllTheSame) {
  const Outcome outcome =
      run_new({folder_.write("run.csv", "t,angle_deg,tau_Nm\n0,1,2\n0.1,2,3\n0.2,bad,2\n0.3,1,2\n")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("run.csv:4: column `angle_deg` has `bad`"));
  EXPECT_TRUE(std::filesystem::exists(rig()));
}

TEST_F(NewCommand, DraftsTheRealRigs) {
  const char* folder = std::getenv("LACUNA_DATA");
  if (!folder) GTEST_SKIP() << "LACUNA_DATA is not set";
  const std::filesystem::path data = folder;
  ASSERT_EQ(run_new({data / "emps/train.csv", data / "emps/test_pulses.csv"}).code, 0);
  EXPECT_THAT(text_of(rig()), HasSubstr("motor = { column = \"vir_V\", unit = \"V\" }"));
  EXPECT_THAT(text_of(robot()), HasSubstr("torque_constant = \"FILL IN N/A\""));
  EXPECT_THAT(text_of(rig()), HasSubstr("position = { column = \"qm_m\", unit = \"m\" }"));
  Recording recording = expect_a_draft_that_works();
  EXPECT_EQ(recording.trials[0].commands.series.samples(0, 0), 2.53862809);

  std::filesystem::remove(rig());
  std::filesystem::remove(robot());
  ASSERT_EQ(run_new({data / "dfki_pendulum/ddp.csv", data / "dfki_pendulum/direct_collocation.csv"}).code, 0);
  recording = expect_a_draft_that_works();
  EXPECT_EQ(recording.trials[1].name, "direct_collocation.csv");
  EXPECT_TRUE(recording.trials[1].held_out);
}

}  // namespace
}  // namespace lacuna
