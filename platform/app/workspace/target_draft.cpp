#include "app/workspace/target_draft.h"

#include "app/workspace/controller_draft.h"
#include "app/workspace/draft_text.h"
#include "config/toml/toml_node.h"
#include "foundation/text/plain_text.h"
#include "foundation/unit.h"
#include "measurement/rest_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace lacuna {
namespace {

bool has_dimension(const std::string& unit, const std::string& of) {
  const std::optional<Unit> a = parse_unit(unit), b = parse_unit(of);
  return a && b && a->same_dimension(*b);
}

/// What the recordings tell about a sensor's noise: the key, and the reason for the comment.
struct NoiseText {
  std::string key;
  std::string reason;
};

NoiseText noise_of(const RigDraft& draft, const std::string& channel, const std::string& unit,
                   const std::string& column_unit) {
  if (!draft.recording) return {};
  std::vector<Trial> fit;
  for (const Trial& trial : draft.recording->trials)
    if (!trial.held_out) fit.push_back(trial);
  const SensorNoise noise = estimate_sensor_noise(fit, channel);
  if (!(noise.standard_deviation > 0.0)) return {"", "noise " + noise.origin(unit)};
  const double written = noise.standard_deviation / parse_unit(column_unit)->to_si;
  return {fmt::format(", noise = \"{:.3g} {}\"", written, column_unit), "noise: " + noise.origin(unit)};
}

std::string unit_or_blank(const GuessedColumn& column, const std::string& si_unit) {
  return has_dimension(column.unit, si_unit) ? toml_text(column.unit) : blank("");
}

/// x and y of a tracked point.
std::string track_line(const RigDraft& draft, const MatchedColumn& match) {
  const GuessedTrack& track = *match.column.track;
  NoiseText noise = noise_of(draft, match.channel.name, match.channel.unit, "rad");
  if (noise.key.empty() && track.scatter > 0.0)
    noise = {fmt::format(", noise = \"{:.2g} rad\"", track.scatter / track.radius),
             "noise: distance of the points from the circle / its radius"};
  return with_comment(
      fmt::format(
          "{} = {{ column = {}, y = {}, unit = {}, pivot = [\"{:.4g} m\", \"{:.4g} m\"], zero = \"-90 deg\"{} }}",
          toml_key(match.channel.name), toml_text(match.column.name), toml_text(track.other),
          toml_text(match.column.unit), track.pivot_x, track.pivot_y, noise.key),
      fmt::format("guessed: {}, radius {:.4g} m; zero: hanging down, y up; gain = -1 reverses the angle; {}",
                  match.column.reason, track.radius, noise.reason));
}

std::string sensor_line(const RigDraft& draft, const MatchedColumn& match) {
  const auto& [channel, column] = match;
  if (column.of_voltage && !column.unit.empty())
    return with_comment(
        fmt::format("{} = {{ column = {}, unit = {}, gain = {} }}", toml_key(channel.name), toml_text(column.name),
                    toml_text(column.unit), blank(fmt::format("{}/{}", channel.unit, column.unit))),
        "guessed: " + column.reason + "; the gain comes from the sensor");
  if (column.track) return track_line(draft, match);
  const bool known = has_dimension(column.unit, channel.unit);
  const NoiseText noise = known ? noise_of(draft, channel.name, channel.unit, column.unit) : NoiseText{};
  const std::string line = fmt::format("{} = {{ column = {}, unit = {}{} }}", toml_key(channel.name),
                                       toml_text(column.name), unit_or_blank(column, channel.unit), noise.key);
  std::string comment = "guessed: " + column.reason;
  if (!known) comment += "; unit such as rad, deg, m, mm, rad/s; for encoder counts \"1\" and counts_per_turn = 4096";
  if (!noise.reason.empty()) comment += "; " + noise.reason;
  return with_comment(line, comment);
}

std::string command_text(const MatchedColumn& match) {
  const GuessedColumn& column = match.column;
  const std::string& wanted = match.channel.unit;
  std::string line = fmt::format("{} = {{ column = {}, unit = ", toml_key(match.channel.name), toml_text(column.name));
  std::string comment = "guessed: " + column.reason;
  if (column.unit.empty()) {
    line += blank("") + " }";
    comment += wanted == "V" ? std::string("; unit V or mV")
                             : fmt::format("; unit {}, or another with a gain such as \"2.5 {}/V\"", wanted, wanted);
  } else if (has_dimension(column.unit, wanted)) {
    line += toml_text(column.unit) + " }";
  } else {
    line += fmt::format("{}, gain = {} }}", toml_text(column.unit), blank(wanted + "/" + column.unit));
    comment += fmt::format("; the gain turns {} into {}", column.unit, wanted);
    if (has_dimension(column.unit, "A")) comment += ": torque constant of the motor, at the joint";
    if (has_dimension(column.unit, "V"))
      comment += "of a current-controlled drive; for a motor driven by this voltage, set its kind to \"voltage\"";
  }
  return with_comment(line, comment);
}

/// A line for each channel of the robot that got no column.
std::string unmatched_text(const RigGuess& guess, bool actuators) {
  std::string text;
  for (const UnmatchedChannel& left : guess.unmatched)
    if (left.is_actuator == actuators)
      text += fmt::format("# not matched: {} in {}, {}\n", left.channel.name, left.channel.unit, reason_of(left));
  return text;
}

std::string file_list(const RigDraft& draft, bool held_out) {
  const std::size_t fit = draft.files.size() - (draft.files.size() > 1 && !draft.guess.trial ? 1 : 0);
  const bool one = (held_out ? draft.files.size() - fit : fit) == 1;
  std::string list;
  for (std::size_t i = held_out ? fit : 0; i < (held_out ? draft.files.size() : fit); ++i)
    list += (one ? "" : "\n  ") + toml_text(path_in_file(draft.files[i].path, draft.experiment)) + (one ? "" : ",");
  return "[" + list + (one ? "]" : "\n]");
}

/// The last trial's name in a column of trials: `runs.csv[3]` → 3.
std::string last_trial(const RigDraft& draft) {
  if (!draft.recording || draft.recording->trials.size() < 2) return {};
  const std::string& name = draft.recording->trials.back().name;
  const std::size_t open = name.rfind('[');
  return open == name.npos ? "" : name.substr(open + 1, name.size() - open - 2);
}

bool has_runs(const RigDraft& draft) {
  return std::ranges::any_of(draft.files, [](const GuessedFile& file) { return !file.run.empty(); });
}

/// Runs that stand side by side in files, one by one.
std::string runs_text(const RigDraft& draft) {
  if (!has_runs(draft)) return "";
  std::string text;
  for (const GuessedFile& file : draft.files) {
    text += fmt::format("\n[[target.recording]]\nfile = {}\ntable = {}\n",
                        toml_text(path_in_file(file.path, draft.experiment)), toml_text(file.run));
    if (&file == &draft.files.back() && draft.files.size() > 1 && !draft.guess.trial)
      text += with_comment("role = \"holdout\"", "guessed: the last run; no fit reads it");
  }
  return text;
}

std::string recordings_text(const RigDraft& draft) {
  const RigGuess& guess = draft.guess;
  std::string text = "[target]\nkind = \"recorded\"\n";
  if (!has_runs(draft)) text += "files = " + file_list(draft, false) + "\n";
  if (guess.trial) {
    text += with_comment("trial_column = " + toml_text(guess.trial->name), "guessed: " + guess.trial->reason);
    if (const std::string last = last_trial(draft); !last.empty())
      text += with_comment("holdout_trials = [" + toml_text(last) + "]", "guessed: the last one; no fit reads it");
  } else if (draft.files.size() > 1 && !has_runs(draft)) {
    text += with_comment("holdout = " + file_list(draft, true), "guessed: the last file; no fit reads it");
  }
  if (!guess.commands.empty())
    text += with_comment(guess.hold == Hold::zero_order ? "hold = \"zero\"" : "hold = \"first\"",
                         "guessed: " + guess.hold_reason);
  text += runs_text(draft);
  text += "\n[target.time]\n" +
          with_comment("column = " + toml_text(guess.time.name), "guessed: " + guess.time.reason) +
          with_comment("unit = " + toml_text(guess.time.unit), "guessed: " + guess.time_unit_reason);
  return text;
}

std::string columns_text(const RigDraft& draft) {
  const RigGuess& guess = draft.guess;
  std::string text = "\n[target.sensors]                        # named like the robot's sensors\n";
  for (const MatchedColumn& sensor : guess.sensors) text += sensor_line(draft, sensor);
  text += unmatched_text(guess, false);
  text += "\n[target.commands]                       # named like the robot's actuators\n";
  for (const MatchedColumn& command : guess.commands) text += command_text(command);
  text += unmatched_text(guess, true);
  for (const GuessedColumn& column : guess.unused)
    if (!is_drafted_set_point(draft, column))
      text += fmt::format("# not used: column {}, {}\n", toml_text(column.name), plain_text(column.reason));
  return text;
}

}  // namespace

std::string target_text(const RigDraft& draft) { return recordings_text(draft) + columns_text(draft); }

std::string reason_of(const UnmatchedChannel& left) {
  if (left.candidates.empty()) return "no column matches";
  std::string columns;
  for (const std::string& name : left.candidates) columns += (columns.empty() ? "" : ", ") + name;
  return (left.candidates.size() > 1 ? "several columns match: " : "a column also matches other channels: ") + columns;
}

}  // namespace lacuna
