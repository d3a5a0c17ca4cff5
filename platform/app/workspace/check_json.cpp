#include "app/workspace/check_json.h"

#include "app/workspace/channel_extent.h"
#include "documents/setup_json.h"

#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using CheckJson = nlohmann::ordered_json;

template <class Spec>
CheckJson names_json(const std::vector<Spec>& specs) {
  CheckJson names = CheckJson::array();
  for (const Spec& spec : specs) names.push_back(spec.name);
  return names;
}

CheckJson checked_robot(const OpenExperiment& opened) {
  const RobotSpec& robot = opened.definition.structure.robot;
  return {{"name", robot.name},
          {"plugin", opened.experiment.model.robot},
          {"bodies", names_json(robot.bodies)},
          {"joints", names_json(robot.joints)},
          {"actuators", names_json(robot.actuators)},
          {"sensors", names_json(robot.sensors)}};
}

CheckJson checked_free(const std::vector<FreeValue>& values) {
  CheckJson list = CheckJson::array();
  for (const FreeValue& value : values)
    list.push_back({{"address", value.address},
                    {"unit", value.unit},
                    {"start", value.start},
                    {"lower", value.lower},
                    {"upper", value.upper}});
  return list;
}

CheckJson checked_effects(const EffectList& effects) {
  CheckJson list = CheckJson::array();
  for (const EffectEntry& effect : effects)
    list.push_back(
        {{"id", effect.id}, {"effect", effect.effect}, {"where", effect.where}, {"optional", effect.optional}});
  return list;
}

CheckJson checked_trials(const std::vector<Trial>& trials) {
  CheckJson list = CheckJson::array();
  for (const Trial& trial : trials)
    list.push_back({{"trial", trial.name},
                    {"held_out", trial.held_out},
                    {"samples", trial.measured.times.size()},
                    {"duration_s", duration_of(trial)}});
  return list;
}

void add_channels(const std::vector<ColumnMapping>& mappings, SeriesKind kind, const std::vector<Trial>& trials,
                  CheckJson& list) {
  for (const ColumnMapping& mapping : mappings) {
    const ChannelExtent extent = extent_of(mapping.channel, kind, trials);
    list.push_back({{"channel", mapping.channel},
                    {"kind", kind == SeriesKind::measured ? "measured" : "commanded"},
                    {"column", mapping.column},
                    {"column_unit", mapping.unit},
                    {"unit", extent.unit},
                    {"smallest", extent.smallest},  // infinite, where there is no value: null
                    {"largest", extent.largest},
                    {"missing", extent.missing}});
  }
}

CheckJson checked_notes(const std::vector<ReadingNote>& notes) {
  CheckJson list = CheckJson::array();
  for (const ReadingNote& note : notes)
    list.push_back({{"file", note.location.file},
                    {"line", note.location.line},
                    {"column", note.location.column},
                    {"message", note.message}});
  return list;
}

}  // namespace

std::string check_json(const OpenExperiment& opened, const std::string& database) {
  const RecordingSource& source = opened.experiment.target.recording;
  CheckJson channels = CheckJson::array();
  add_channels(source.sensors, SeriesKind::measured, opened.trials, channels);
  add_channels(source.commands, SeriesKind::commanded, opened.trials, channels);
  return CheckJson{{"experiment", opened.experiment.name},
                   {"database", database},
                   {"target", opened.experiment.target.kind},
                   {"robot", checked_robot(opened)},
                   {"free", checked_free(opened.definition.free)},
                   {"effects", checked_effects(opened.definition.effects)},
                   {"trials", checked_trials(opened.trials)},
                   {"channels", channels},
                   {"setups", setups_json(known_setups(opened.definition, source))},
                   {"notes", checked_notes(opened.notes)}}
             .dump(2) +
         "\n";
}

}  // namespace lacuna
