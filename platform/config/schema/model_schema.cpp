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
          .key("start", &FreeRange::start, number(""), "where the search begins; else the robot's own value")
          .check({"range", "start"},
                 [](const TomlNode& node, Reading& reading, FreeRange& range) {
                   if (!range.start || (*range.start >= range.lower && *range.start <= range.upper)) return;
                   reading.problem_at("start", node.find("start")->location, "lies outside the range");
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
        fmt::format("the id {} is taken by effects[{}]; give it an id of its own", toml_text(id), first->second));
  }
}

void check_names_a_robot(const TomlNode& node, Reading& reading, ModelSection& model) {
  const bool has_file = node.find("file") != nullptr;
  if (model.robot.empty() && has_file) model.robot = "declared";
  if (model.robot.empty())
    reading.problem_at("robot", node.location, "is missing: a robot plugin's name, or file = \"robot.toml\"");
  else if (model.robot == "declared" && !has_file)
    reading.problem_at("file", node.location,
                       "is missing: the robot \"declared\" is read from the file that this key names");
}

}  // namespace

Table<EffectEntry> effect_keys() {
  return Table<EffectEntry>()
      .key("id", &EffectEntry::id, element_name(),
           "name within this list; the parameters are effect.ID.PARAMETER; without it the effect's name")
      .required("effect", &EffectEntry::effect, element_name(), "an effect plugin's name")
      .key("where", &EffectEntry::where, one_or_list_of(text()),
           "elements such as \"joint.hinge\", * for all; they share one set of values; none: the world")
      .key("start", &EffectEntry::start, map_of("PARAMETER", number("")),
           "values where they differ from the effect's defaults")
      .key("fixed", &EffectEntry::fixed, list_of(text()), "parameters that a fit leaves alone")
      .key("range", &EffectEntry::range, map_of("PARAMETER", range_of(number(""))),
           "bounds of a parameter for fits and searches, [lower, upper], within what the effect allows")
      .check({}, complete_effect);
}

Table<EffectEntry> model_effect_keys() {
  return effect_keys().key("optional", &EffectEntry::optional, boolean(),
                           "a run whose encoding has switches, as parameters_and_effects, may leave it out of models; "
                           "everything else takes it as it is");
}

Table<ModelSection> system_keys(const std::string& whose) {
  const bool of_model = whose == "model";
  const std::string kind = of_model ? "" : "simulated: ";
  return Table<ModelSection>()
      .key("robot", &ModelSection::robot, element_name(),
           kind + "a robot plugin's name; \"declared\" where file is given")
      .key("parameters", &ModelSection::parameters, map_of("PARAMETER", number("")), kind + "of the robot plugin")
      .key("file", &ModelSection::file, existing_file(), kind + "of a declared robot: TOML, URDF or MJCF")
      .key("base", &ModelSection::base,
           choice<RobotBase>(
               {{"as_written", RobotBase::as_written}, {"held", RobotBase::held}, {"free", RobotBase::free}}),
           kind +
               "of a file in URDF or MJCF: whether the body that all others hang on is held to the world or floats; "
               "as_written: what the file says, and held where it says nothing")
      .key("held", &ModelSection::held, list_of(text()),
           kind +
               "joints of the file that stand still at position zero, such as \"joint.finger_*\"; their actuators and "
               "sensors are left out")
      .key("actuator_kinds", &ModelSection::drive,
           map_of("ACTUATOR", choice<ActuatorKind>({{"force", ActuatorKind::force},
                                                    {"position_servo", ActuatorKind::position_servo},
                                                    {"velocity_servo", ActuatorKind::velocity_servo}})),
           kind +
               "of a file in URDF or MJCF: what was commanded, where the file says something else or nothing, as in "
               "{ \"actuator.*\" = \"position_servo\" }")
      .key("set", &ModelSection::set, map_of("ADDRESS", number("").or_infinite()),
           kind + "values that differ from the robot's own and stay fixed, as in \"body.arm.mass\" = 0.5")
      .key("effects", &ModelSection::effects, list_of((of_model ? model_effect_keys() : effect_keys()).value()),
           "Physical effects that the " + std::string(of_model ? "" : "simulated ") + whose + " includes." +
               (of_model ? " `lacuna add` and `undo` edit this list and nothing else in the file." : ""))
      .check({"effects"}, check_ids);
}

Table<ModelSection> model_keys() {
  return system_keys("model")
      .key("free", &ModelSection::free, free_ranges(), "values that a fit may change, within these bounds")
      .key<std::string>(
          "encoding", element_name(), "parameters",
          [](ModelSection& model, std::string&& name) { model.encoding.name = std::move(name); },
          "what a model's genome means: a model encoding plugin")
      .key<std::map<std::string, double>>(
          "encoding_parameters", map_of("PARAMETER", number("")), {},
          [](ModelSection& model, std::map<std::string, double>&& read) {
            model.encoding.parameters = std::move(read);
          },
          "of that plugin")
      .key("approximate", &ModelSection::approximate, boolean(),
           "the start values are a first model: a run begins with the exploration phase instead of a random test")
      .check({"robot"}, check_names_a_robot);
}

}  // namespace lacuna
