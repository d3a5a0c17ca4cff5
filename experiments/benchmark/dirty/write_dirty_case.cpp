#include "dirty/write_dirty_case.h"

#include "dirty/logged_unit.h"
#include "dirty/toml_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

constexpr double kLongestStep = 0.01;   ///< s, of the model
constexpr double kFilterSamples = 1.5;  ///< time constant of the controllers' low-pass (true_trial.cpp)

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::string recording_table(const DirtyCase& made, const RecordedTrial& trial) {
  std::string text = fmt::format("[[target.recording]]\nfile = \"{}.csv\"\n", trial.name);
  if (trial.held_out) text += "role = \"holdout\"\n";
  return text + fmt::format("with = [{{ file = \"{}_tracker.csv\", offset = {} }}]\n\n", trial.name,
                            toml_number(made.recording.second_offset));
}

std::string files(const DirtyCase& made, bool held_out) {
  std::vector<std::string> names;
  for (const RecordedTrial& trial : made.recorded)
    if (trial.held_out == held_out) names.push_back(fmt::format("\"{}.csv\"", trial.name));
  return fmt::format("[{}]", fmt::join(names, ", "));
}

std::string target_text(const DirtyCase& made) {
  const char* hold = made.rig.driving == Driving::imposed ? "first" : "zero";
  std::string text = "[target]\nkind = \"recorded\"\n";
  if (!made.recording.two_devices) {
    text += fmt::format("files = {}\n", files(made, false));
    if (made.recorded.size() > 1) text += fmt::format("holdout = {}\n", files(made, true));
  }
  text += fmt::format("hold = \"{}\"\n\n", hold);
  if (made.recording.two_devices)
    for (const RecordedTrial& trial : made.recorded) text += recording_table(made, trial);
  const LoggedUnit time = unit_of_time(made.recording);
  return text + fmt::format("[target.time]\ncolumn = \"{}\"\nunit = \"{}\"\n\n", column_name("time", time), time.name);
}

std::string sensor_columns(const DirtyCase& made) {
  std::string text = "[target.sensors]\n";
  for (std::size_t s = 0; s < made.rig.stated.sensors.size(); ++s) {
    const std::string& name = made.rig.stated.sensors[s].name;
    const LoggedUnit unit = unit_of_sensor(made, s);
    text += fmt::format("{} = {{ column = \"{}\", unit = \"{}\"", name, column_name(name, unit), unit.name);
    if (made.recording.declares_noise) {
      const double noise = std::max(made.recording.white[s], made.recording.quantum[s] / std::sqrt(12.0));
      text += fmt::format(", noise = \"{:.3g} {}\"", noise * unit.per_si, unit.name);
    }
    text += " }\n";
  }
  return text + "\n";
}

std::string command_columns(const DirtyCase& made) {
  if (made.rig.stated.drives.empty()) return "";
  std::string text = "[target.commands]\n";
  for (std::size_t d = 0; d < made.rig.stated.drives.size(); ++d) {
    const PlantDrive& drive = made.rig.stated.drives[d];
    const LoggedUnit unit = unit_of_command(made, d);
    const bool imposed = made.rig.driving == Driving::imposed;
    const std::string column = imposed ? column_name("position", unit) : column_name(drive.name, unit);
    text += fmt::format("{} = {{ column = \"{}\", unit = \"{}\"", drive.name, column, unit.name);
    if (imposed) text += ", derivative = true";
    if (unit.name == "A") {
      const bool slides = made.rig.stated.joints[static_cast<std::size_t>(drive.joint)].slides;
      text += fmt::format(", gain = \"{} {}/A\"", toml_number(made.recording.amperes), slides ? "N" : "N*m");
    }
    text += " }\n";
  }
  return text + "\n";
}

/// Whether the owner can state the controller's law: it reads what it controls.
bool states_controllers(const DirtyCase& made) {
  const bool by_rate = made.rig.driving == Driving::velocity_loop;
  return made.plan.states_controller && !made.recording.two_devices && made.rig.stated.sensors[0].velocity == by_rate;
}

std::string controller_laws(const DirtyCase& made) {
  if (!states_controllers(made)) return "";
  std::string text = "[target.controllers]\n";
  const bool by_rate = made.rig.driving == Driving::velocity_loop;
  for (std::size_t d = 0; d < made.rig.loops.size(); ++d) {
    const Loop& loop = made.rig.loops[d];
    const PlantDrive& drive = made.rig.stated.drives[d];
    const bool slides = made.rig.stated.joints[static_cast<std::size_t>(drive.joint)].slides;
    const std::string force = slides ? "N" : "N*m", way = slides ? "m" : "rad";
    const LoggedUnit unit = unit_of_reference(made, d);
    text += fmt::format("{} = {{ reads = \"{}\", reference = {{ column = \"{}\", unit = \"{}\" }}", drive.name,
                        made.rig.stated.sensors[static_cast<std::size_t>(drive.joint)].name,
                        column_name("wanted_" + drive.name, unit), unit.name);
    text +=
        fmt::format(", proportional = \"{} {}{}/{}\"", toml_number(loop.proportional), force, by_rate ? "*s" : "", way);
    if (loop.integral > 0.0)
      text += fmt::format(", integral = \"{} {}/{}\"", toml_number(loop.integral), force,
                          by_rate ? way : fmt::format("({}*s)", way));
    if (loop.derivative > 0.0)
      text += fmt::format(", derivative = \"{} {}*s/{}\", filter = \"{} s\"", toml_number(loop.derivative), force, way,
                          toml_number(kFilterSamples * made.rig.interval));
    text += " }\n";
  }
  return text + "\n";
}

std::string free_values(const DirtyCase& made) {
  std::string text = "[model.free]\n";
  for (const OwnerFree& one : made.rig.free) {
    const double stated = one.value.in(made.rig.stated);
    text += fmt::format("\"{}\" = [{}, {}]\n", one.value.address(made.rig.stated), toml_number(one.lower * stated),
                        toml_number(one.upper * stated));
  }
  return text;
}

/// A row of numbers in the units of the log.
std::string table_text(const Table& table, const std::vector<std::string>& names, const std::vector<double>& per_si) {
  std::string text = fmt::format("{}\n", fmt::join(names, ","));
  for (const std::vector<double>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      text += fmt::format("{}{:.9g}", c == 0 ? "" : ",", row[c] * per_si[c] + 0.0);  // never -0
    text += '\n';
  }
  return text;
}

/// The columns of a trial's first file, or of its second one.
void write_table(const DirtyCase& made, const Table& table, bool second, const std::filesystem::path& file) {
  const LoggedUnit time = unit_of_time(made.recording);
  std::vector<std::string> names = {column_name("time", time)};
  std::vector<double> per_si = {time.per_si};
  const auto add = [&](const std::string& channel, const LoggedUnit& unit) {
    names.push_back(column_name(channel, unit));
    per_si.push_back(unit.per_si);
  };
  const PlantSpec& spec = made.rig.stated;
  if (!second)
    for (std::size_t d = 0; d < spec.drives.size(); ++d) add(spec.drives[d].name, unit_of_command(made, d));
  const std::size_t first = made.recording.two_devices && !second ? 1 : 0;
  for (std::size_t s = first; s < spec.sensors.size(); ++s) add(spec.sensors[s].name, unit_of_sensor(made, s));
  for (std::size_t d = 0; made.recording.logs_reference && !second && d < made.rig.loops.size(); ++d)
    add("wanted_" + spec.drives[d].name, unit_of_reference(made, d));
  write_file(file, table_text(table, names, per_si));
}

}  // namespace

std::string experiment_text(const DirtyCase& made) {
  const double interval = made.rig.interval;
  const double step = interval / std::ceil(interval / kLongestStep - 1e-9);
  return fmt::format(
      "[experiment]\nname = \"{}\"\nseed = 1\n\n{}{}{}{}[model]\nfile = \"robot.toml\"\neffects = []\n\n{}\n"
      "[engine]\nstep = {}\n",
      made.plan.name(), target_text(made), sensor_columns(made), command_columns(made), controller_laws(made),
      free_values(made), toml_number(step));
}

void write_dirty_case(const DirtyCase& made, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_file(folder / "robot.toml", robot_text(made));
  write_file(folder / "rig.toml", experiment_text(made));
  for (const RecordedTrial& trial : made.recorded) {
    write_table(made, trial.table, false, folder / (trial.name + ".csv"));
    if (made.recording.two_devices) write_table(made, trial.second, true, folder / (trial.name + "_tracker.csv"));
  }
}

}  // namespace hidden_effects::dirty
