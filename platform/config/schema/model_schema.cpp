#include "config/schema/experiment_schema.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

Value<FreeRange> free_range() {
  using Bounds = std::pair<double, double>;
  const Value<FreeRange> bounds = mapped<FreeRange, Bounds>(range_of(number("")), [](Bounds&& range) {
    return FreeRange{"", range.first, range.second, std::nullopt};
  });
  const Value<FreeRange> with_start =
      Table<FreeRange>()
          .required<Bounds>(
              "range", range_of(number("")),
              [](FreeRange& range, Bounds&& read) {
                range.lower = read.first;
                range.upper = read.second;
              },
              "lower and upper bound")
          .key("start", &FreeRange::start, number(""), "start value; default: the value of the robot file")
          .check({"range", "start"},
                 [](const TomlNode& node, Reading& reading, FreeRange& range) {
                   if (!range.start || (*range.start >= range.lower && *range.start <= range.upper)) return;
                   reading.problem_at("start", node.find("start")->location, "is outside the range");
                 })
          .value();
  return either(bounds, with_start);
}

Value<std::vector<FreeRange>> free_ranges() {
  return named<std::vector<FreeRange>, FreeRange>(
      "ADDRESS", free_range(), [](std::vector<FreeRange>& ranges, const TomlMember& member, FreeRange&& range) {
        range.pattern = member.name;
        ranges.push_back(std::move(range));
      });
}

void complete_effect(const TomlNode&, Reading&, EffectEntry& effect) {
  if (effect.id.empty()) effect.id = effect.effect;
}

void check_ids(const TomlNode& node, Reading& reading, ModelSection& model) {
  std::map<std::string, std::size_t> taken;
  for (std::size_t i = 0; i < model.effects.size(); ++i) {
    const std::string& id = model.effects[i].id;
    const auto [first, is_new] = taken.emplace(id, i);
    if (is_new || id.empty()) continue;
    reading.problem_at(
        fmt::format("effects[{}]", i), node.find("effects")->items[i].location,
        fmt::format("effects[{1}] has the id {0} already; choose another id", toml_text(id), first->second));
  }
}

void check_names_a_robot(const TomlNode& node, Reading& reading, ModelSection& model) {
  const bool has_file = node.find("file") != nullptr;
  if (model.robot.empty() && has_file) model.robot = "declared";
  if (model.robot.empty())
    reading.problem_at("robot", node.location, "is missing: the name of a robot plugin, or file = \"robot.toml\"");
  else if (model.robot == "declared" && !has_file)
    reading.problem_at("file", node.location,
                       "is missing: the robot \"declared\" is read from the file that this key names");
}

}  // namespace

Table<EffectEntry> effect_keys() {
  return Table<EffectEntry>()
      .key("id", &EffectEntry::id, element_name(),
           "id of the entry; its parameters are effect.ID.PARAMETER; default: the effect's name")
      .required("effect", &EffectEntry::effect, element_name(), "name of an effect plugin")
      .key("where", &EffectEntry::where, one_or_list_of(text()),
           "elements such as \"joint.hinge\", * for all; all of them share one set of values; empty: the world")
      .key("start", &EffectEntry::start, map_of("PARAMETER", number("")),
           "start values that differ from the effect's defaults")
      .key("fixed", &EffectEntry::fixed, list_of(text()), "parameters that are not fitted")
      .key("range", &EffectEntry::range, map_of("PARAMETER", range_of(number(""))),
           "bounds of a parameter for fits and searches, [lower, upper], within the bounds of the effect")
      .check({}, complete_effect);
}

Table<EffectEntry> model_effect_keys() {
  return effect_keys().key("optional", &EffectEntry::optional, boolean(),
                           "a run whose encoding has switches, such as parameters_and_effects, may leave this effect "
                           "out of models; all other commands always include it");
}

Table<ModelSection> system_keys(const std::string& whose) {
  const bool of_model = whose == "model";
  const std::string kind = of_model ? "" : "simulated: ";
  return Table<ModelSection>()
      .key("robot", &ModelSection::robot, element_name(),
           kind + "name of a robot plugin; \"declared\" if file is given")
      .key("parameters", &ModelSection::parameters, map_of("PARAMETER", number("")),
           kind + "parameters of the robot plugin")
      .key("file", &ModelSection::file, existing_file(), kind + "robot file: TOML, URDF or MJCF")
      .key("base", &ModelSection::base,
           choice<RobotBase>(
               {{"as_written", RobotBase::as_written}, {"held", RobotBase::held}, {"free", RobotBase::free}}),
           kind +
               "for URDF or MJCF: whether the root body is fixed to the world (held) or floats (free); as_written: as "
               "the file says, held if it says nothing")
      .key("held", &ModelSection::held, list_of(text()),
           kind +
               "joints of the file that are fixed at position zero, such as \"joint.finger_*\"; their actuators and "
               "sensors are left out")
      .key("actuator_kinds", &ModelSection::drive,
           map_of("ACTUATOR", choice<ActuatorKind>({{"force", ActuatorKind::force},
                                                    {"position_servo", ActuatorKind::position_servo},
                                                    {"velocity_servo", ActuatorKind::velocity_servo}})),
           kind +
               "for URDF or MJCF: kind of each actuator, if the file has another one or none, as in { \"actuator.*\" = "
               "\"position_servo\" }")
      .key("set", &ModelSection::set, map_of("ADDRESS", number("").or_infinite()),
           kind + "fixed values that replace those of the robot file, as in \"body.arm.mass\" = 0.5")
      .key("effects", &ModelSection::effects, list_of((of_model ? model_effect_keys() : effect_keys()).value()),
           "Physical effects that the " + std::string(of_model ? "" : "simulated ") + whose + " includes." +
               (of_model ? " `lacuna add` and `undo` edit only this list." : ""))
      .check({"effects"}, check_ids);
}

Table<ModelSection> model_keys() {
  return system_keys("model")
      .key("free", &ModelSection::free, free_ranges(), "values that a fit may change, with their bounds")
      .key<std::string>(
          "encoding", element_name(), "parameters",
          [](ModelSection& model, std::string&& name) { model.encoding.name = std::move(name); },
          "name of the model encoding plugin, which decodes genomes into models")
      .key<std::map<std::string, double>>(
          "encoding_parameters", map_of("PARAMETER", number("")), {},
          [](ModelSection& model, std::map<std::string, double>&& read) {
            model.encoding.parameters = std::move(read);
          },
          "parameters of this plugin")
      .key("approximate", &ModelSection::approximate, boolean(),
           "the start values are a first model: a run begins with an exploration phase instead of a random test")
      .check({"robot"}, check_names_a_robot);
}

}  // namespace lacuna
