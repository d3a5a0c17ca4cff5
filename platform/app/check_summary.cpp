#include "app/check_summary.h"

#include "foundation/unit.h"

#include <fmt/format.h>

#include <vector>

namespace lacuna {
namespace {

std::string counted(std::size_t count, const std::string& word) {
  const bool in_y = word.ends_with('y');
  if (count == 1) return "1 " + word;
  return fmt::format("{} {}", count, in_y ? word.substr(0, word.size() - 1) + "ies" : word + "s");
}

template <class Spec>
std::string names(const std::vector<Spec>& specs) {
  std::string text;
  for (const Spec& spec : specs) text += (text.empty() ? "" : ", ") + spec.name;
  return text.empty() ? "none" : text;
}

std::string line(const std::string& head, const std::string& text) { return fmt::format("{:<10}{}\n", head, text); }

std::string effect_lines(const EffectList& effects) {
  std::string text;
  for (const EffectEntry& effect : effects)
    text += line(text.empty() ? "effects" : "",
                 fmt::format("{}: {} @ {}", effect.id, effect.effect,
                             effect.where.empty() ? "world" : fmt::format("{}", fmt::join(effect.where, ", "))));
  return text.empty() ? line("effects", "none") : text;
}

std::string free_lines(const std::vector<FreeValue>& values) {
  std::string text;
  for (const FreeValue& value : values)
    text += line(text.empty() ? "free" : "",
                 fmt::format("{} from {}, {} to {}", value.address, format_quantity(value.start, value.unit),
                             format_quantity(value.lower, value.unit), format_quantity(value.upper, value.unit)));
  return text.empty() ? line("free", "none") : text;
}

std::string trial_lines(const std::vector<Trial>& trials) {
  std::string text;
  for (const Trial& trial : trials) {
    const Eigen::VectorXd& times = trial.measured.times;
    const double duration = times.size() > 0 ? times[times.size() - 1] - times[0] : 0.0;
    text +=
        line(text.empty() ? "trials" : "",
             fmt::format("{}{}: {}, {}", trial.name, trial.held_out ? " (held out)" : "",
                         counted(static_cast<std::size_t>(times.size()), "sample"), format_quantity(duration, "s")));
  }
  return text.empty() ? line("trials", "none") : text;
}

std::string note_lines(const std::vector<ReadingNote>& notes) {
  std::string text;
  for (const ReadingNote& note : notes) text += line("note", to_string(note.location) + ": " + note.message);
  return text;
}

}  // namespace

std::string check_summary(const Experiment& experiment, const ModelDefinition& definition, const Recording& recording) {
  const RobotSpec& robot = definition.structure.robot;
  return line("robot",
              fmt::format("{} ({}), {}", robot.name, experiment.model.robot, counted(robot.bodies.size(), "body"))) +
         line("joints", names(robot.joints)) + line("actuators", names(robot.actuators)) +
         line("sensors", names(robot.sensors)) + free_lines(definition.free) + effect_lines(definition.effects) +
         trial_lines(recording.trials) + note_lines(recording.notes);
}

}  // namespace lacuna
