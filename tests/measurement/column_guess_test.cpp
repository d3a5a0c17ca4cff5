#include "measurement/names/column_name.h"
#include "measurement/names/column_words.h"
#include "measurement/rig_guess.h"
#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(UnitInName, IsFoundInBracketsAndAfterUnderscores) {
  const std::pair<const char*, const char*> kNames[] = {{"theta_rad", "rad"},
                                                        {"theta_dot_rad_s", "rad/s"},
                                                        {"tau_Nm", "N*m"},
                                                        {"vir_V", "V"},
                                                        {"angle [deg]", "deg"},
                                                        {"torque (Nm)", "N*m"},
                                                        {"acc_m_s2", "m/s^2"},
                                                        {"speed [m/s]", "m/s"},
                                                        {"phi[\u00b0]", "deg"},
                                                        {"time_ms", "ms"},
                                                        {"stamp_us", "us"},
                                                        {"omega_rpm", "rpm"},
                                                        {"velocity_in_s", "in/s"},
                                                        {"displacement [in]", "in"},
                                                        {"friction_force_kip", "kip"},
                                                        {"torque_in", ""},
                                                        {"torque_lbfin", "lbf*in"},
                                                        {"x_1", ""},
                                                        {"joint_min", ""},
                                                        {"angle", ""},
                                                        {"q", ""},
                                                        {"load [kg\u00b7m\u00b2]", "kg*m^2"},
                                                        {"note [maybe]", ""},
                                                        {"t_sec", "s"},
                                                        {"Motorstrom in A", "A"},
                                                        {"x/m", "m"},
                                                        {"v/(m/s)", "m/s"},
                                                        {"omega / rad/s", "rad/s"},
                                                        {"speed rad/s", "rad/s"},
                                                        {"Torque, Nm", "N*m"},
                                                        {"torque_nm", "N*m"},
                                                        {"Velocity (m/s) Run #1", "m/s"},
                                                        {"phi[\u00b0] filtered", "deg"},
                                                        {"angle_deg_", "deg"},
                                                        {"speed_rad_per_s", "rad/s"},
                                                        {"Angle..deg.", "deg"},
                                                        {"angleDeg", "deg"},
                                                        {"torque_N.m", "N*m"},
                                                        {"motor A", ""},
                                                        {"/arm/m", ""},
                                                        {"Rad", ""},
                                                        {"_s", ""},
                                                        {"", ""}};
  for (const auto& [name, unit] : kNames) EXPECT_EQ(unit_in_name(name), unit) << name;
  EXPECT_EQ(name_without_unit("theta_dot_rad_s"), "theta_dot");
  EXPECT_EQ(name_without_unit("angle [deg]"), "angle");
}

TEST(ColumnWords, AreSplitAtCaseAndDigits) {
  EXPECT_THAT(words_of("ElbowAngle_deg"), ElementsAre("elbow", "angle"));
  EXPECT_THAT(words_of("q12"), ElementsAre("q", "12"));
  EXPECT_THAT(words_of("motor current [A]"), ElementsAre("motor", "current"));
  EXPECT_EQ(joint_in_words(words_of("ElbowAngle_deg")), "elbow");
  EXPECT_EQ(role_in_words(words_of("theta_dot")), ColumnRole::velocity);
  EXPECT_EQ(role_in_words(words_of("theta_ref")), ColumnRole::reference);
  EXPECT_EQ(role_in_words(words_of("blue")), std::nullopt);
  EXPECT_EQ(role_in_words(words_of("temperature")), ColumnRole::other);
  EXPECT_EQ(role_in_words(words_of("main_voltage")), ColumnRole::other);
  EXPECT_EQ(role_in_words(words_of("bus_current")), ColumnRole::other);
  EXPECT_THAT(words_of("Motorstrom in A"), ElementsAre("motor", "strom"));
  EXPECT_THAT(words_of("Sollwinkel"), ElementsAre("soll", "winkel"));
  EXPECT_THAT(words_of("Pendelwinkel"), ElementsAre("pendel", "winkel"));
  EXPECT_THAT(words_of("velocit\u00e0"), ElementsAre("velocita"));
  EXPECT_EQ(role_in_words(words_of("position error")), ColumnRole::other);
  EXPECT_EQ(role_in_words(words_of("current angle")), ColumnRole::position);
  EXPECT_EQ(role_in_words(words_of("pos_cmd")), ColumnRole::reference);
  EXPECT_EQ(role_in_words(words_of("run time")), ColumnRole::time);
  EXPECT_EQ(role_in_words(words_of("Run #")), ColumnRole::trial);
}

class GuessRig : public testing::Test {
 protected:
  RigGuess guess(const std::string& content, const ColumnHints& hints = {}) const {
    return guess_rig({sample_file(folder_.write("run.csv", content))}, hints);
  }
  TestFolder folder_;
};

TEST_F(GuessRig, TakesDatesForTheTime) {
  const RigGuess rig = guess(
      "logged,q_deg,tau_Nm\n2024-05-01T12:00:00.990Z,1,0\n2024-05-01T12:00:01.000Z,2,1\n"
      "2024-05-01T12:00:01.010Z,3,0\n");
  EXPECT_EQ(rig.time.name, "logged");
  EXPECT_EQ(rig.time.unit, "s");
}

TEST_F(GuessRig, TakesTimesOfDayForTheTime) {
  const RigGuess rig = guess(
      "logged,q_deg,tau_Nm\n12:59:59.990,1,0\n13:00:00.000,2,1\n"
      "13:00:00.010,3,0\n");
  EXPECT_EQ(rig.time.name, "logged");
  EXPECT_EQ(rig.time.unit, "s");
}

/// As ROS writes them, in either order.
TEST_F(GuessRig, TakesSecondsForTheTimeWhosePartsAreInAColumnOfTheirOwn) {
  for (const char* content :
       {"sec,nanosec,q_deg,tau_Nm\n7,980000000,1,0\n7,990000000,2,1\n8,0,3,1\n8,10000000,2,0\n",
        "nanosec,sec,q_deg,tau_Nm\n980000000,7,1,0\n990000000,7,2,1\n0,8,3,1\n10000000,8,2,0\n"}) {
    const RigGuess rig = guess(content);
    EXPECT_EQ(rig.time.name, "sec") << content;
    EXPECT_EQ(rig.time.unit, "s") << content;
    EXPECT_EQ(rig.joints.size(), 1u) << content;
  }
}

TEST_F(GuessRig, OfAPendulum) {
  const RigGuess rig = guess("t_s,theta_rad,theta_dot_rad_s,tau_Nm\n0,0,0,1\n0.002,0.1,5,1\n0.004,0.2,5,1\n");
  EXPECT_EQ(rig.time.name, "t_s");
  EXPECT_EQ(rig.time.unit, "s");
  ASSERT_EQ(rig.joints.size(), 1u);
  const GuessedJoint& joint = rig.joints[0];
  EXPECT_EQ(joint.name, "hinge");
  EXPECT_EQ(joint.position->name, "theta_rad");
  EXPECT_EQ(joint.velocity->name, "theta_dot_rad_s");
  EXPECT_EQ(joint.command->name, "tau_Nm");
  EXPECT_TRUE(rig.unused.empty());
}

TEST_F(GuessRig, TellsTheReferenceByItsLead) {
  std::string text = "t_s,qm_m,qg_m,vir_V,pulses_N\n";
  for (int i = 0; i < 500; ++i) {
    const double t = 0.01 * i;
    text += fmt::format("{},{},{},{},{}\n", t, std::sin(t - 0.02), std::sin(t), std::cos(t), i == 250 ? 5 : 0);
  }
  const RigGuess rig = guess(text);
  ASSERT_EQ(rig.joints.size(), 1u);
  EXPECT_EQ(rig.joints[0].name, "slider");
  EXPECT_EQ(rig.joints[0].position->name, "qm_m");
  EXPECT_EQ(rig.joints[0].command->name, "vir_V") << "the busier of two";
  ASSERT_EQ(rig.unused.size(), 2u);
  EXPECT_EQ(rig.unused[0].name, "pulses_N");
  EXPECT_EQ(rig.unused[1].name, "qg_m");
  EXPECT_EQ(rig.unused[1].reason, "`qm_m` follows it with a lag; `vir_V` drives the joint");
}

TEST_F(GuessRig, PutsColumnsToJointsByTheirNumbersAndNames) {
  const RigGuess rig =
      guess("time,shoulder_pos_deg,elbow_pos_deg,elbow_torque,shoulder_torque,elbow_vel\n0,1,2,3,4,5\n1,1,2,3,4,5\n");
  ASSERT_EQ(rig.joints.size(), 2u);
  EXPECT_EQ(rig.time.unit, "ms") << rig.time_unit_reason;
  EXPECT_EQ(rig.joints[0].name, "shoulder");
  EXPECT_EQ(rig.joints[0].command->name, "shoulder_torque");
  EXPECT_FALSE(rig.joints[0].velocity);
  EXPECT_EQ(rig.joints[1].command->name, "elbow_torque");
  EXPECT_EQ(rig.joints[1].velocity->name, "elbow_vel");
}

TEST_F(GuessRig, TakesAReferenceForAServosCommandWhereNothingElseDrives) {
  const RigGuess rig = guess("t,angle_deg,angle_ref_deg\n0,0,0\n0.01,0,5\n0.02,2,9\n");
  EXPECT_EQ(rig.joints[0].actuator, ActuatorKind::position_servo);
  EXPECT_EQ(rig.joints[0].command->name, "angle_ref_deg");
  EXPECT_EQ(command_unit(rig.joints[0]), "rad");
}

TEST_F(GuessRig, FindsTimeByItsRiseAndTrialsByName) {
  const RigGuess rig = guess("run,counter,q\na,100,3\na,200,2\nb,300,4\n");
  EXPECT_EQ(rig.time.name, "counter");
  EXPECT_EQ(rig.time.unit, "ms");
  ASSERT_TRUE(rig.trial);
  EXPECT_EQ(rig.trial->name, "run");
}

TEST_F(GuessRig, BelievesTheUser) {
  ColumnHints hints;
  hints.time = "b";
  hints.positions = {"c"};
  hints.commands = {"a"};
  const RigGuess rig = guess("a,b,c\n0,5,3\n1,4,3\n2,6,3\n", hints);
  EXPECT_EQ(rig.time.name, "b");
  EXPECT_EQ(rig.joints[0].position->name, "c");
  EXPECT_EQ(rig.joints[0].command->name, "a");
  hints.time = "tme";
  EXPECT_THROW(guess("a,b,c\n0,5,3\n", hints), Error);
}

TEST_F(GuessRig, SaysWhatItCannotFind) {
  const auto complaint = [&](const std::string& content) {
    try {
      guess(content);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(complaint("a,b\n1,2\n1,2\n"), HasSubstr("no column increases as time does; name it with --time"));
  EXPECT_THAT(complaint("t,blue\n1,2\n2,2\n"),
              HasSubstr("name one with --position or --velocity. The columns are `t`, `blue`"));
  EXPECT_THAT(complaint(""), HasSubstr("run.csv: is empty"));
  const FileSample one = sample_file(folder_.write("one.csv", "t,q\n0,1\n1,2\n"));
  const FileSample two = sample_file(folder_.write("two.csv", "time,q\n0,1\n1,2\n"));
  EXPECT_THROW(guess_rig({one, two}, {}), Error);
}

}  // namespace
}  // namespace lacuna
