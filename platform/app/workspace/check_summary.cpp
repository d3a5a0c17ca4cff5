#include "app/workspace/check_summary.h"

#include "app/workspace/channel_extent.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/unit_text.h"
#include "app/workspace/note_sentences.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lacuna {
namespace {

template <class Spec>
std::string names(const std::vector<Spec>& specs) {
  std::string text;
  for (const Spec& spec : specs) text += (text.empty() ? "" : ", ") + spec.name;
  return text.empty() ? "none" : text;
}

std::string summary_line(const std::string& head, const std::string& text) {
  return fmt::format("{:<10}{}\n", head, plain_text(text));
}

std::string effect_lines(const EffectList& effects) {
  std::string text;
  for (const EffectEntry& effect : effects)
    text += summary_line(text.empty() ? "effects" : "",
                         fmt::format("{}: {} @ {}{}", effect.id, effect.effect,
                                     effect.where.empty() ? "world" : fmt::format("{}", fmt::join(effect.where, ", ")),
                                     effect.optional ? ", optional" : ""));
  return text.empty() ? summary_line("effects", "none") : text;
}

std::string free_lines(const std::vector<FreeValue>& values) {
  std::string text;
  for (const FreeValue& value : values)
    text += summary_line(
        text.empty() ? "free" : "",
        fmt::format("{}: start {}, bounds {} to {}", value.address, format_quantity(value.start, value.unit),
                    format_quantity(value.lower, value.unit), format_quantity(value.upper, value.unit)));
  return text.empty() ? summary_line("free", "none") : text;
}

constexpr double kSameRate = 0.7;  ///< a few readings may be missing

/// Readings of each sensor per second; `all`: samples of any of them, which is the rate where one device wrote all.
std::string rates_of(const Trial& trial, double all) {
  std::string own;
  bool differ = false;
  const TimeSeries& series = trial.measured;
  for (std::size_t c = 0; c < series.channels.size(); ++c) {
    const auto column = series.samples.col(static_cast<Eigen::Index>(c)).array();
    const double rate = (static_cast<double>(column.isFinite().count()) - 1.0) / duration_of(trial);
    differ = differ || rate < kSameRate * all;
    own += fmt::format("{}{} {:.4g} Hz", own.empty() ? "" : ", ", series.channels[c].name, rate);
  }
  return differ ? own : fmt::format("{:.4g} Hz", all);
}

std::string trial_line(const Trial& trial) {
  const auto samples = static_cast<std::size_t>(trial.measured.times.size());
  const double duration = duration_of(trial);
  std::string text = fmt::format("{}{}: {}, {}", trial.name, trial.held_out ? " (held out)" : "",
                                 counted(samples, "sample"), format_quantity(duration, "s"));
  return duration > 0.0 ? text + ", " + rates_of(trial, static_cast<double>(samples - 1) / duration) : text;
}

std::string trial_lines(const std::vector<Trial>& trials) {
  if (trials.empty()) return summary_line("trials", "none");
  std::string text;
  std::size_t samples = 0;
  double seconds = 0.0;
  for (const Trial& trial : trials) {
    text += summary_line(text.empty() ? "trials" : "", trial_line(trial));
    samples += static_cast<std::size_t>(trial.measured.times.size());
    seconds += duration_of(trial);
  }
  if (trials.size() > 1)
    text += summary_line("", fmt::format("total {}, {}", counted(samples, "sample"), format_quantity(seconds, "s")));
  return text;
}

/// " × 50 mN·m/A": the gain in the unit in which it is written.
std::string gain_text(const ColumnMapping& mapping) {
  if (mapping.gain_unit.empty()) return mapping.gain == 1.0 ? "" : fmt::format(" × {:.7g}", mapping.gain);
  const std::optional<Unit> unit = parse_unit(mapping.gain_unit);
  return fmt::format(" × {:.7g} {}", mapping.gain / (unit ? unit->to_si : 1.0), unit_text(mapping.gain_unit));
}

std::string mapping_text(const ColumnMapping& mapping, const ChannelExtent& extent, const char* what) {
  const std::string& y = mapping.track.other;
  std::string text = fmt::format("{}, {}: {}", mapping.channel, what,
                                 y.empty() ? "column " + mapping.column : "columns " + mapping.column + " and " + y);
  if (mapping.unit != "1") text += " in " + unit_text(mapping.unit);
  text += gain_text(mapping);
  if (extent.smallest <= extent.largest)
    text += fmt::format(", {} to {}", format_quantity(extent.smallest, extent.unit),
                        format_quantity(extent.largest, extent.unit));
  if (extent.missing > 0) text += fmt::format(", {} not compared", counted(extent.missing, "value"));
  return text;
}

std::string channel_lines(const RecordingSource& source, const std::vector<Trial>& trials) {
  std::string text;
  const auto add = [&](const std::vector<ColumnMapping>& mappings, const char* what, SeriesKind kind) {
    for (const ColumnMapping& mapping : mappings)
      text += summary_line(text.empty() ? "channels" : "",
                           mapping_text(mapping, extent_of(mapping.channel, kind, trials), what));
  };
  add(source.sensors, "measured", SeriesKind::measured);
  add(source.commands, "commanded", SeriesKind::commanded);
  return text;
}

/// What makes a model move: of each actuator with a column, or its controller.
std::string drive_lines(const RecordingSource& source, const RobotSpec& robot) {
  std::string text;
  for (const ColumnMapping& command : source.commands) {
    const auto actuator = std::find_if(robot.actuators.begin(), robot.actuators.end(),
                                       [&](const ActuatorSpec& one) { return one.name == command.channel; });
    if (actuator == robot.actuators.end()) continue;
    const bool has_law = std::any_of(source.controllers.begin(), source.controllers.end(),
                                     [&](const ControllerMapping& law) { return law.actuator == command.channel; });
    const char* how = ": by the recorded command, open loop";
    if (source.by_controllers && has_law)
      how = ": by its controller, closed loop";
    else if (actuator->kind == ActuatorKind::motion)
      how = ": its motion is imposed";
    else if (actuator->kind != ActuatorKind::force && actuator->kind != ActuatorKind::voltage)
      how = ": a servo on the recorded goal, closed loop";
    text += summary_line(text.empty() ? "driven" : "", command.channel + how);
  }
  return text;
}

std::string note_lines(const std::vector<ReadingNote>& notes) {
  std::string text;
  for (const std::string& sentence : note_sentences(notes)) text += summary_line("note", sentence);
  return text;
}

}  // namespace

std::string check_summary(const Experiment& experiment, const ModelDefinition& definition,
                          const std::vector<Trial>& trials, const std::vector<ReadingNote>& notes) {
  const RobotSpec& robot = definition.structure.robot;
  const std::string from =
      experiment.model.declared ? experiment.model.file.filename().string() : "plugin " + experiment.model.robot;
  return summary_line("robot", fmt::format("{} ({}), {}", robot.name, from, counted(robot.bodies.size(), "body"))) +
         summary_line("joints", names(robot.joints)) + summary_line("actuators", names(robot.actuators)) +
         summary_line("sensors", names(robot.sensors)) + free_lines(definition.free) +
         effect_lines(definition.effects) + trial_lines(trials) + channel_lines(experiment.target.recording, trials) +
         drive_lines(experiment.target.recording, robot) + note_lines(notes);
}

}  // namespace lacuna
