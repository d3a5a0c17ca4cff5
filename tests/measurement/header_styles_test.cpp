#include "measurement/rig_guess.h"
#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// What the columns of a made file hold, by letter: t, T time in s, ms; q, Q an angle in rad, deg; v its velocity;
/// u a command; r a setpoint that the angle follows; a an acceleration; n a count of rows; z zeros; f a height in ft,
/// F the same in m; g its velocity in ft/s, G in m/s.
double value_of(char kind, int row) {
  const double t = 0.01 * row, angle = 0.4 * std::sin(6.0 * t) + 0.1 * std::sin(17.0 * t);
  constexpr double kFoot = 0.3048, kDegree = 180.0 / std::numbers::pi;
  switch (kind) {
    case 't': return t;
    case 'T': return 1e3 * t;
    case 'q': return angle;
    case 'Q': return kDegree * angle;
    case 'v': return 2.4 * std::cos(6.0 * t) + 1.7 * std::cos(17.0 * t);
    case 'u': return 0.3 * std::sin(11.0 * t + 0.3);
    case 'r': return 0.4 * std::sin(6.0 * (t + 0.03)) + 0.1 * std::sin(17.0 * (t + 0.03));
    case 'a': return -14.4 * std::sin(6.0 * t) - 28.9 * std::sin(17.0 * t);
    case 'n': return row;
    case 'f': return (40.0 - 4.9 * t * t) / kFoot;
    case 'F': return 40.0 - 4.9 * t * t;
    case 'g': return -9.8 * t / kFoot;
    case 'G': return -9.8 * t;
    default: return 0.0;
  }
}

/// A file: lines as they are, then rows.
struct Written {
  std::vector<std::string> lines;
  std::string columns;
  char delimiter = ',';
  bool decimal_comma = false;
};

std::string text_of(const Written& file) {
  std::string text;
  for (const std::string& line : file.lines) text += line + "\n";
  for (int row = 0; row < 60; ++row) {
    for (std::size_t c = 0; c < file.columns.size(); ++c) {
      std::string cell = fmt::format("{:.5f}", value_of(file.columns[c], row));
      if (file.decimal_comma) cell.replace(cell.find('.'), 1, ",");
      text += (c == 0 ? "" : std::string(1, file.delimiter)) + cell;
    }
    text += "\n";
  }
  return text;
}

/// "Zeit [ms] | hinge q Winkel [deg] u Strom [A] force": time, then each joint with its columns, units as guessed.
std::string in_short(const RigGuess& guess) {
  std::string text = fmt::format("{} [{}]", guess.time.name, guess.time.unit);
  if (guess.trial) text += " trial " + guess.trial->name;
  for (const GuessedJoint& joint : guess.joints) {
    text += " | " + joint.name;
    const auto add = [&](const char* what, const std::optional<GuessedColumn>& column) {
      if (column) text += fmt::format(" {} {} [{}]", what, column->name, column->unit);
    };
    add("q", joint.position);
    add("v", joint.velocity);
    add("u", joint.command);
    if (!joint.command) continue;
    const ActuatorKind kind = joint.actuator;
    text += kind == ActuatorKind::voltage          ? " voltage"
            : kind == ActuatorKind::position_servo ? " position_servo"
            : kind == ActuatorKind::velocity_servo ? " velocity_servo"
                                                   : " force";
  }
  return text;
}

struct Style {
  const char* program;
  Written file;
  const char* guessed;
};

void PrintTo(const Style& style, std::ostream* out) { *out << style.program; }

class HeaderStyle : public testing::TestWithParam<Style> {
 protected:
  TestFolder folder_;
};

TEST_P(HeaderStyle, IsRead) {
  const std::filesystem::path file = folder_.write("run.csv", text_of(GetParam().file));
  EXPECT_EQ(in_short(guess_rig({sample_file(file)}, {})), GetParam().guessed);
}

const std::vector<Style>& styles() {
  static const std::vector<Style> kStyles = {
      {"capstone",
       {{"\xef\xbb\xbf\"Time (s) Run #1\";\"Position (m) Run #1\";\"Velocity (m/s) Run #1\""}, "tqv", ';', true},
       "Time (s) Run #1 [s] | slider q Position (m) Run #1 [m] v Velocity (m/s) Run #1 [m/s]"},
      {"capstone_side_by_side",
       {{"Time (s) Run #1,Angle (rad) Run #1,Time (s) Run #2,Angle (rad) Run #2"}, "tqtq"},
       "Time (s) Run #1 [s] | hinge q Angle (rad) Run #1 [rad]"},
      {"capstone_runs_with_one_time",
       {{"Time (s),Angle (rad) Run #3,Angle (rad) Run #4"}, "tqq"},
       "Time (s) [s] | hinge q Angle (rad) Run #3 [rad]"},
      {"logger_pro",
       {{"Latest: Time (s),Latest: Position (m),Latest: Velocity (m/s),Latest: Acceleration (m/s\xc2\xb2)"}, "tqva"},
       "Latest: Time (s) [s] | slider q Latest: Position (m) [m] v Latest: Velocity (m/s) [m/s]"},
      {"graphical_analysis",
       {{"Data Set 1:Time(s),Data Set 1:Angle(rad),Data Set 2:Time(s),Data Set 2:Angle(rad)"}, "tqtq"},
       "Data Set 1:Time(s) [s] | hinge q Data Set 1:Angle(rad) [rad]"},
      {"run_in_front",
       {{"Run 1: Time (s),Run 1: Angle (deg)"}, "tQ"},
       "Run 1: Time (s) [s] | hinge q Run 1: Angle (deg) [deg]"},
      {"phyphox",
       {{"\"Time (s)\",\"Gyroscope x (rad/s)\",\"Angle (rad)\""}, "tvq"},
       "Time (s) [s] | hinge q Angle (rad) [rad] v Gyroscope x (rad/s) [rad/s]"},
      {"tracker_video", {{"mass_A\t\t", "t\ty\t"}, "tq", '\t'}, "t [s] | hinge q y []"},
      {"plotjuggler",
       {{"__time,/joint_states/arm/position,/joint_states/arm/velocity,/joint_states/arm/effort"}, "tqvu"},
       "__time [s] | hinge q /joint_states/arm/position [] v /joint_states/arm/velocity [] u /joint_states/arm/effort "
       "[] "
       "force"},
      {"rostopic_echo",
       {{"%time,field.header.seq,field.position0,field.velocity0,field.effort0"}, "tzqvu"},
       "time [s] | hinge q field.position0 [] v field.velocity0 [] u field.effort0 [] force"},
      {"ros_two_joints",
       {{"time,position_shoulder,position_elbow,velocity_shoulder,velocity_elbow,effort_shoulder,effort_elbow"},
        "tqrvauu"},
       "time [s] | shoulder q position_shoulder [] v velocity_shoulder [] u effort_shoulder [] force | elbow q "
       "position_elbow [] v velocity_elbow [] u effort_elbow [] force"},
      {"dynamixel",
       {{"timestamp_ms,goal_position_deg,present_position_deg"}, "TrQ"},
       "timestamp_ms [ms] | hinge q present_position_deg [deg] u goal_position_deg [deg] position_servo"},
      {"simulink",
       {{"time,Plant/theta [rad],Plant/omega [rad/s],Plant/u [V]"}, "tqvu"},
       "time [s] | hinge q Plant/theta [rad] [rad] v Plant/omega [rad/s] [rad/s] u Plant/u [V] [V] voltage"},
      {"matlab_valid_names",
       {{"Time_s_,Angle_deg_,Speed_rad_s_,Torque_Nm_"}, "tQvu"},
       "Time_s_ [s] | hinge q Angle_deg_ [deg] v Speed_rad_s_ [rad/s] u Torque_Nm_ [N*m] force"},
      {"r_names",
       {{"Time..s.,Angle..deg.,Current..A."}, "tQu"},
       "Time..s. [s] | hinge q Angle..deg. [deg] u Current..A. [A] force"},
      {"labview_lvm",
       {{"LabVIEW Measurement", "Writer_Version\t2", "Separator\tTab", "Date\t2024/03/01", "***End_of_Header***",
         "Channels\t2", "Samples\t60\t60", "X_Value\tAngle (deg)\tTorque (Nm)"},
        "tQu",
        '\t'},
       "X_Value [s] | hinge q Angle (deg) [deg] u Torque (Nm) [N*m] force"},
      {"labview_two_columns",
       {{"Operator;Lab 3", "Sample rate;100", "Gain;2", "Comment;first try", "Time [s];Angle [deg]"}, "tQ", ';', true},
       "Time [s] [s] | hinge q Angle [deg] [deg]"},
      {"dspace",
       {{"ControlDesk recording", "", "path,description,unit", "Time [s],Model Root/phi_deg,Model Root/i_A"}, "tQu"},
       "Time [s] [s] | hinge q Model Root/phi_deg [deg] u Model Root/i_A [A] force"},
      {"preamble_with_commas",
       {{"Bench 2, pendulum, first, try", "t_s,angle_deg,tau_Nm"}, "tQu"},
       "t_s [s] | hinge q angle_deg [deg] u tau_Nm [N*m] force"},
      {"units_below",
       {{"Time;Angle;Torque", "s;deg;Nm"}, "tQu", ';'},
       "Time [s] | hinge q Angle [deg] u Torque [N*m] force"},
      {"units_below_in_latin1",
       {{"Zeit;Winkel;Temperatur",
         "ms;\xb0;\xb0"
         "C"},
        "TQz",
        ';',
        true},
       "Zeit [ms] | hinge q Winkel [deg]"},
      {"units_below_with_micro",
       {{"Zeit;Weg", "\xb5s;\xb5m"}, "Tq", ';'},
       "Zeit [\xc2\xb5s] | slider q Weg [\xc2\xb5m]"},
      {"units_below_preamble",
       {{"Pr\xfc"
         "fstand 4",
         "Zeit;Winkel;Moment", "[s];[\xb0];[Nm]"},
        "tQu",
        ';',
        true},
       "Zeit [s] | hinge q Winkel [deg] u Moment [N*m] force"},
      {"units_below_with_blanks",
       {{"time,angle,effort", "s,rad,-"}, "tqu"},
       "time [s] | hinge q angle [rad] u effort [] force"},
      {"german_setpoint",
       {{"Zeit in s;Sollwinkel in Grad;Istwinkel in Grad;Motorstrom in A"}, "trQu", ';', true},
       "Zeit in s [s] | hinge q Istwinkel in Grad [deg] u Motorstrom in A [A] force"},
      {"german_servo",
       {{"Zeit [s];Sollwinkel [\xc2\xb0];Istwinkel [\xc2\xb0]"}, "trQ", ';', true},
       "Zeit [s] [s] | hinge q Istwinkel [\xc2\xb0] [deg] u Sollwinkel [\xc2\xb0] [deg] position_servo"},
      {"german_speed",
       {{"Zeit;Solldrehzahl;Istdrehzahl", "s;U/min;U/min"}, "trv", ';'},
       "Zeit [s] | hinge v Istdrehzahl [rpm] u Solldrehzahl [rpm] velocity_servo"},
      {"german_words",
       {{"Zeit;Pendelwinkel;Winkelgeschwindigkeit;Drehmoment"}, "tqvu", ';'},
       "Zeit [s] | hinge q Pendelwinkel [] v Winkelgeschwindigkeit [] u Drehmoment [] force"},
      {"german_voltage",
       {{"Zeit / s;Weg / mm;Motorspannung / V"}, "tqu", ';', true},
       "Zeit / s [s] | slider q Weg / mm [mm] u Motorspannung / V [V] voltage"},
      {"german_latin1",
       {{"Zeit [s];H\xf6he [m];Kraft [N]"}, "tqu", ';', true},
       "Zeit [s] [s] | slider q H\xc3\xb6he [m] [m] u Kraft [N] [N] force"},
      {"din", {{"t/s;phi/\xc2\xb0;M/Nm"}, "tQu", ';'}, "t/s [s] | hinge q phi/\xc2\xb0 [deg] u M/Nm [N*m] force"},
      {"greek",
       {{"t [s],\xce\xb8 [rad],\xcf\x89 [rad/s],\xcf\x84 [N\xc2\xb7m]"}, "tqvu"},
       "t [s] [s] | hinge q \xce\xb8 [rad] [rad] v \xcf\x89 [rad/s] [rad/s] u \xcf\x84 [N\xc2\xb7m] [N*m] force"},
      {"greek_without_units", {{"t,\xcf\x86,\xcf\x84"}, "tqu"}, "t [s] | hinge q \xcf\x86 [] u \xcf\x84 [] force"},
      {"french",
       {{"temps (s);consigne (deg);angle mesur\xc3\xa9 (deg)"}, "trQ", ';', true},
       "temps (s) [s] | hinge q angle mesur\xc3\xa9 (deg) [deg] u consigne (deg) [deg] position_servo"},
      {"french_torque",
       {{"Temps;Vitesse;Couple", "s;tr/min;Nm"}, "tvu", ';'},
       "Temps [s] | hinge v Vitesse [rpm] u Couple [N*m] force"},
      {"spanish",
       {{"Tiempo (ms),\xc3\x81ngulo (grados),Corriente (mA)"}, "TQu"},
       "Tiempo (ms) [ms] | hinge q \xc3\x81ngulo (grados) [deg] u Corriente (mA) [mA] force"},
      {"italian",
       {{"tempo [s];posizione [mm];velocit\xc3\xa0 [mm/s];tensione [V]"}, "tqvu", ';'},
       "tempo [s] [s] | slider q posizione [mm] [mm] v velocit\xc3\xa0 [mm/s] [mm/s] u tensione [V] [V] voltage"},
      {"topic_in_front", {{"pendel/zeit;pendel/winkel"}, "tq", ';'}, "pendel/zeit [s] | hinge q pendel/winkel []"},
      {"device_in_front",
       {{"encoder/time,encoder/velocity,encoder/torque"}, "tvu"},
       "encoder/time [s] | hinge v encoder/velocity [] u encoder/torque [] force"},
      {"word_at_end",
       {{"t_s_filtered,angle_deg_filtered,torque_Nm_filtered"}, "tQu"},
       "t_s_filtered [s] | hinge q angle_deg_filtered [deg] u torque_Nm_filtered [N*m] force"},
      {"comma_units",
       {{"\"Time, ms\",\"Angle, deg\",\"Torque, Nm\""}, "TQu"},
       "Time, ms [ms] | hinge q Angle, deg [deg] u Torque, Nm [N*m] force"},
      {"unit_behind_space",
       {{"Time ms,Angle deg,Speed rpm"}, "TQv"},
       "Time ms [ms] | hinge q Angle deg [deg] v Speed rpm [rpm]"},
      {"camel_case",
       {{"timeMs,angleDeg,motorCurrent_mA"}, "TQu"},
       "timeMs [ms] | hinge q angleDeg [deg] u motorCurrent_mA [mA] force"},
      {"set_point",
       {{"time_s,set point,process value angle"}, "trq"},
       "time_s [s] | hinge q process value angle [] u set point [] position_servo"},
      {"target_and_current",
       {{"time,target_angle,current_angle"}, "trq"},
       "time [s] | hinge q current_angle [] u target_angle [] position_servo"},
      {"cmd_and_feedback",
       {{"t,cmd_vel_rad_s,fb_vel_rad_s"}, "trv"},
       "t [s] | hinge v fb_vel_rad_s [rad/s] u cmd_vel_rad_s [rad/s] velocity_servo"},
      {"cmd_without_quantity",
       {{"t_s,cmd_wrist_rad,pos_wrist_rad,vel_wrist_rad_s"}, "trqv"},
       "t_s [s] | hinge q pos_wrist_rad [rad] v vel_wrist_rad_s [rad/s] u cmd_wrist_rad [rad] position_servo"},
      {"des_and_act", {{"t,q_des,q_act,tau_des"}, "trqu"}, "t [s] | hinge q q_act [] u tau_des [] force"},
      {"voltage_without_unit",
       {{"t,theta,motor_voltage"}, "tqu"},
       "t [s] | hinge q theta [] u motor_voltage [] voltage"},
      {"millivolts", {{"t_s,theta_rad,u_mV"}, "tqu"}, "t_s [s] | hinge q theta_rad [rad] u u_mV [mV] voltage"},
      {"supply_is_no_drive",
       {{"t_s,theta_rad,supply_V,tau_Nm"}, "tqau"},
       "t_s [s] | hinge q theta_rad [rad] u tau_Nm [N*m] force"},
      {"potentiometer", {{"t_s,angle_V,tau_Nm"}, "tqu"}, "t_s [s] | hinge q angle_V [V] u tau_Nm [N*m] force"},
      {"error_is_no_joint",
       {{"t,angle_deg,angle_error_deg,pwm_duty"}, "tQau"},
       "t [s] | hinge q angle_deg [deg] u pwm_duty [] force"},
      {"feet_and_metres",
       {{"t(s),alt(ft),vz(ft/s),alt(m),vz(m/s)"}, "tfgFG"},
       "t(s) [s] | slider q alt(m) [m] v vz(m/s) [m/s]"},
      {"degrees_and_radians", {{"t,theta_deg,theta_rad"}, "tQq"}, "t [s] | hinge q theta_rad [rad]"},
      {"trial_number", {{"Versuch Nr.;Zeit;Winkel"}, "ztq", ';'}, "Zeit [s] trial Versuch Nr. | hinge q Winkel []"},
  };
  return kStyles;
}

INSTANTIATE_TEST_SUITE_P(Programs, HeaderStyle, testing::ValuesIn(styles()),
                         [](const testing::TestParamInfo<Style>& one) { return std::string(one.param.program); });

class HeaderReasons : public testing::Test {
 protected:
  RigGuess guess(const Written& file) const {
    return guess_rig({sample_file(folder_.write("run.csv", text_of(file)))}, {});
  }
  static std::string reason(const RigGuess& guess, const std::string& column) {
    for (const GuessedColumn& unused : guess.unused)
      if (unused.name == column) return unused.reason;
    return "";
  }
  TestFolder folder_;
};

TEST_F(HeaderReasons, NameTheRunThatIsRead) {
  const RigGuess rig = guess({{"Time (s) Run #1,Angle (rad) Run #1,Time (s) Run #2,Angle (rad) Run #2"}, "tqtq"});
  EXPECT_EQ(reason(rig, "Angle (rad) Run #2"), "`Run #1` is used; copy `Run #2` to a separate file");
}

TEST_F(HeaderReasons, NameTheColumnInAnotherUnit) {
  EXPECT_EQ(reason(guess({{"t(s),alt(ft),alt(m)"}, "tfF"}), "alt(ft)"), "`alt(m)` in another unit");
}

TEST_F(HeaderReasons, NameWhatDrivesInsteadOfASetpoint) {
  const RigGuess rig = guess({{"Zeit;Sollwinkel;Istwinkel;Motorstrom in A"}, "trqu", ';'});
  EXPECT_EQ(reason(rig, "Sollwinkel"), "its name says that it is a setpoint; `Motorstrom in A` drives the joint");
}

TEST_F(HeaderReasons, NameABatteryAsSuch) {
  EXPECT_EQ(reason(guess({{"t_s,theta_rad,supply_V"}, "tqa"}), "supply_V"),
            "its name is neither that of a motion nor of a drive");
}

TEST_F(HeaderReasons, SayHowToUseAnotherDrive) {
  EXPECT_THAT(reason(guess({{"t,q,tau,current_A"}, "tquz"}), "current_A"), HasSubstr("name it with --command"));
}

TEST_F(HeaderReasons, AFileIsReadTheSameWayWithItsTimeNamed) {
  const Written file{{"Bench 2, pendulum, first, try", "Time,2024", "Time,q", "s,rad"}, "tq"};
  RecordingSource source = pendulum_source(folder_.write("run.csv", text_of(file)));
  source.time_column = "Time";
  source.commands.clear();
  const Recording recording = read_recording(source, {{"angle", "rad"}}, {}, {"joint.hinge"});
  EXPECT_EQ(recording.trials[0].measured.times.size(), 60);
  EXPECT_THAT(notes_of(recording), HasSubstr("run.csv:3: the header was found in this line"));
}

TEST_F(HeaderReasons, ADriveThatIsNotReadIsNoted) {
  RecordingSource source = pendulum_source(folder_.write("run.csv", text_of({{"t;q;Motorstrom in A"}, "tqu", ';'})));
  const std::string sentence = "no actuator has commands, and `Motorstrom in A` is not read";
  source.commands[0].column = "Motorstrom in A";
  source.commands[0].unit = "A";
  source.commands[0].gain_unit = "N*m/A";
  EXPECT_THAT(notes_of(read_pendulum(source)), testing::Not(HasSubstr(sentence)));
  source.commands.clear();
  EXPECT_THAT(notes_of(read_recording(source, {{"angle", "rad"}}, {}, {"joint.hinge"})), HasSubstr(sentence));
}

}  // namespace
}  // namespace lacuna
