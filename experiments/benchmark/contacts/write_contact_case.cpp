#include "contacts/write_contact_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <stdexcept>

namespace hidden_effects {
namespace {

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::string files_text(const MadeContactCase& made, bool held_out) {
  std::vector<std::string> names;
  for (const ContactTrial& trial : made.trials)
    if (trial.held_out == held_out) names.push_back(fmt::format("\"{}.csv\"", trial.name));
  return fmt::format("[{}]", fmt::join(names, ", "));
}

std::string columns_text(const ContactRig& rig, NoiseLevel noise) {
  std::string text = "[target.sensors]\n";
  for (const ContactChannel& channel : rig.channels) {
    text += fmt::format("\"{0}\" = {{ column = \"{0}\", unit = \"{1}\"", channel.name, channel.unit);
    text += channel.touch() ? " }\n" : fmt::format(", noise = {:.2g} }}\n", deviation(channel, noise));
  }
  text += "\n[target.commands]\n";
  for (const ContactDrive& drive : rig.drives)
    text += fmt::format("{0} = {{ column = \"{0}\", unit = \"{1}\" }}\n", drive.name, drive.unit);
  text += "\n[target.initial]\n";
  for (const ContactStart& start : rig.starts)
    text += fmt::format("{} = {{ position = {:.6f}, knowledge = \"given\" }}\n", start.joint, start.position);
  return text;
}

std::string recording_text(const ContactRig& rig, const ContactTrial& trial) {
  std::string text = "t";
  for (const ContactDrive& drive : rig.drives) text += "," + drive.name;
  for (const ContactChannel& channel : rig.channels) text += "," + channel.name;
  text += '\n';
  for (std::size_t k = 0; k < trial.readings.front().size(); ++k) {
    text += fmt::format("{:.6g}", static_cast<double>(k) * rig.interval);
    for (const Samples* samples : {&trial.commands, &trial.readings})
      for (const std::vector<double>& values : *samples) text += fmt::format(",{:.9g}", values[k]);
    text += '\n';
  }
  return text;
}

std::string rig_text(const MadeContactCase& made, const std::vector<SizedContactLaw>& laws) {
  return fmt::format(
      "[experiment]\nname = \"{}\"\nseed = 1\n\n[target]\nkind = \"recorded\"\nfiles = {}\nholdout = {}\nhold = "
      "\"zero\"\n\n[target.time]\ncolumn = \"t\"\n\n{}\n{}",
      made.plan.name(), files_text(made, false), files_text(made, true), columns_text(*made.rig, made.plan.noise),
      model_text(*made.rig, Integration::owner, laws));
}

}  // namespace

void write_contact_robot(const ContactRig& rig, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  if (!rig.robot.empty()) write_text(folder / "robot.toml", rig.robot);
}

void write_contact_case(const MadeContactCase& made, const std::filesystem::path& folder,
                        const std::vector<SizedContactLaw>& laws) {
  write_text(folder / "rig.toml", rig_text(made, laws));
  for (const ContactTrial& trial : made.trials)
    write_text(folder / (trial.name + ".csv"), recording_text(*made.rig, trial));
}

}  // namespace hidden_effects
