#include "app/workspace/draft_report.h"

#include "app/workspace/controller_draft.h"
#include "config/schema/blank.h"
#include "foundation/address.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "report/text/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

std::string label_of(const GuessedFile& file) {
  return plain_text(file.path.filename().string() + (file.run.empty() ? "" : "[" + file.run + "]"));
}

/// "x and y" of a tracked point, else the column.
std::string columns_of(const GuessedColumn& column) {
  return column.name + (column.track ? " and " + column.track->other : "");
}

/// Runs that stand side by side in files.
void print_runs(const RigDraft& draft) {
  for (std::size_t i = 0; i < draft.files.size(); ++i) {
    std::string size;
    for (const Trial& trial : draft.recording ? draft.recording->trials : std::vector<Trial>{})
      if (trial.name == label_of(draft.files[i]))
        size = fmt::format(": {}, {:.3g} s", counted(static_cast<std::size_t>(trial.measured.times.size()), "sample"),
                           trial.measured.times(trial.measured.times.size() - 1));
    std::printf("  %-18s %s%s\n", i == 0 ? "runs" : "", label_of(draft.files[i]).c_str(), size.c_str());
  }
}

/// The circle that the point moves on.
void print_track(const RigGuess& guess) {
  for (const MatchedColumn& sensor : guess.sensors)
    if (const std::optional<GuessedTrack>& track = sensor.column.track)
      std::printf("  %-18s points on a circle of radius %.4g m about (%.4g m, %.4g m), mean distance from it %.2g mm\n",
                  "track", track->radius, track->pivot_x, track->pivot_y, 1e3 * track->scatter);
}

void print_column(const std::string& what, const GuessedColumn& column, const std::string& reason) {
  std::printf("  %-18s column %s%s%s (%s)\n", what.c_str(), columns_of(column).c_str(),
              column.unit.empty() ? "" : " in ", column.unit.c_str(), reason.c_str());
}

void print_joints(const RigGuess& guess) {
  for (const GuessedJoint& joint : guess.joints) {
    std::printf("  %-18s a %s\n", ("joint." + joint.name).c_str(), joint.slides ? "slider" : "hinge");
    if (joint.position) print_column("  " + joint.position_sensor(), *joint.position, joint.position->reason);
    if (joint.velocity) print_column("  " + joint.velocity_sensor(), *joint.velocity, joint.velocity->reason);
    if (joint.command) print_column("  " + joint.motor(), *joint.command, joint.command->reason);
  }
}

/// The joint, or the body, that a sensor or an actuator is at.
std::string place_of(const RobotSpec& robot, const std::string& channel, bool is_actuator) {
  if (is_actuator) {
    const auto found = std::ranges::find(robot.actuators, channel, &ActuatorSpec::name);
    return found == robot.actuators.end() ? "" : found->joint;
  }
  for (const SensorSpec& sensor : robot.sensors)
    for (const Channel& one : sensor_channels(robot, sensor))
      if (one.name == channel) return sensor.element;
  return "";
}

/// A row for each sensor and each actuator of a robot that is known.
void print_matches(const RigGuess& guess, const RobotSpec& robot) {
  std::vector<std::vector<std::string>> rows{{"  joint", "robot channel", "unit", "file column", "unit", "matched by"}};
  const auto add = [&](bool is_actuator, const Channel& channel, std::vector<std::string> column) {
    std::vector<std::string>& row = rows.emplace_back(
        std::vector<std::string>{"  " + place_of(robot, channel.name, is_actuator),
                                 (is_actuator ? "actuator." : "sensor.") + channel.name, channel.unit});
    row.insert(row.end(), column.begin(), column.end());
  };
  for (const bool is_actuator : {false, true}) {
    for (const MatchedColumn& match : is_actuator ? guess.commands : guess.sensors)
      add(is_actuator, match.channel, {columns_of(match.column), match.column.unit, match.column.reason});
    for (const UnmatchedChannel& left : guess.unmatched)
      if (left.is_actuator == is_actuator) add(is_actuator, left.channel, {"-", "", reason_of(left)});
  }
  std::fputs(text_table(std::move(rows), 6).c_str(), stdout);
}

}  // namespace

void print_guesses(const RigDraft& draft) {
  const RigGuess& guess = draft.guess;
  std::printf("guessed\n");
  print_column("time", guess.time, guess.time.reason);
  if (guess.trial) print_column("trials", *guess.trial, guess.trial->reason);
  if (draft.known_robot)
    print_matches(guess, *draft.known_robot);
  else
    print_joints(guess);
  print_track(guess);
  for (const GuessedColumn& column : guess.unused) {
    const bool is_set_point = is_drafted_set_point(draft, column);
    print_column(
        is_set_point ? "set point" : "not used", column,
        is_set_point ? "its name says that it is a reference; drafted under target.controllers" : column.reason);
  }
  if (!guess.commands.empty())
    std::printf("  %-18s %s: %s\n", "hold", guess.hold == Hold::zero_order ? "zero" : "first",
                guess.hold_reason.c_str());
  if (draft.interval > 0.0)
    std::printf("  %-18s %.4g Hz, %s\n", "sampling", 1.0 / draft.interval,
                counted(draft.recording->trials.size(), "trial").c_str());
  const GuessedFile& last = draft.files.back();
  if (!last.run.empty()) print_runs(draft);
  if (!guess.trial && draft.files.size() > 1)
    std::printf("  %-18s %s (the last %s)\n", "held out", label_of(last).c_str(), last.run.empty() ? "file" : "run");
}

/// The lines with blanks, as places to go to.
void print_blanks(const std::filesystem::path& file, const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.starts_with('#') || line.find('"' + std::string(kBlank)) == line.npos) continue;
    const std::size_t comment = line.find("  # ");
    std::printf("  %s  %s\n", to_string(SourceLocation{file.string(), number, 0}).c_str(),
                line.substr(0, std::min(comment, line.find_last_not_of(' ', comment) + 1)).c_str());
  }
}

}  // namespace lacuna
