#include "config/schema/experiment_schema.h"

#include "config/toml/path_variables.h"
#include "foundation/text/problem.h"
#include "foundation/unit.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace lacuna {
namespace {

constexpr auto kLargestSeed = std::numeric_limits<std::int64_t>::max();

/// `{ uniform = [1.0, 7.0] }`.
Value<FreeRange> hidden_range() {
  return Table<FreeRange>()
      .required<std::pair<double, double>>(
          "uniform", range_of(number("")),
          [](FreeRange& range, std::pair<double, double>&& read) { std::tie(range.lower, range.upper) = read; },
          "the value is drawn uniformly between these two")
      .value();
}

Table<ModelSection> hidden_keys() {
  return system_keys("target").key(
      "hidden", &ModelSection::free,
      named<std::vector<FreeRange>, FreeRange>(
          "ADDRESS", hidden_range(),
          [](std::vector<FreeRange>& ranges, const TomlMember& member, FreeRange&& range) {
            range.pattern = member.name;
            ranges.push_back(std::move(range));
          }),
      "Hidden values, each drawn independently, as in \"body.*.mass\" = { uniform = [1.0, 7.0] }");
}

Table<SimulatedSource> simulated_keys() {
  return Table<SimulatedSource>()
      .merged(&SimulatedSource::system, hidden_keys())
      .key("hidden_seed", &SimulatedSource::hidden_seed, whole_number<std::uint64_t>(0, kLargestSeed),
           "simulated: seed of the hidden values")
      .key("redraw", &SimulatedSource::redraw,
           choice<Redraw>({{"never", Redraw::never}, {"replicate", Redraw::replicate}}),
           "simulated: whether each replicate has other hidden values")
      .key("noise", &SimulatedSource::noise, map_of("SENSOR", number("").at_least(0.0)),
           "simulated: standard deviation of white measurement noise, as in \"sensor.angle*\" = 0.002")
      .key("substeps", &SimulatedSource::substeps, whole_number<int>(0, 1000000),
           "simulated: integration steps per engine.step of the target; 0: as for models (engine.substeps)");
}

/// A folder that is there, variables replaced, from the experiment file's.
Value<std::filesystem::path> existing_folder() {
  Value<std::filesystem::path> value;
  value.shape.kind = Shape::Kind::text;
  value.shape.meaning = "a folder's path";
  value.read = [plain = text()](const TomlNode& node, Reading& reading, std::filesystem::path& result) {
    std::string written;
    if (!plain.read(node, reading, written)) return false;
    try {
      result = reading.directory() / replace_variables(written);
      if (std::filesystem::is_directory(result)) return true;
      reading.problem(node, toml_text(written) + " is not a folder; paths are relative to the experiment file");
    } catch (const Error& error) {
      reading.problem(node, error.what());
    }
    return false;
  };
  value.write = [](const std::filesystem::path& shown) { return shown.empty() ? "" : toml_text(shown.string()); };
  return value;
}

/// A text in which variables such as `${HOME}` are replaced.
Value<std::string> text_with_variables() {
  Value<std::string> value = text();
  value.read = [plain = text()](const TomlNode& node, Reading& reading, std::string& result) {
    if (!plain.read(node, reading, result)) return false;
    try {
      result = replace_variables(result);
      return true;
    } catch (const Error& error) {
      reading.problem(node, error.what());
      return false;
    }
  };
  return value;
}

}  // namespace

Table<ProcessSource> process_keys() {
  return Table<ProcessSource>()
      .key("command", &ProcessSource::command, list_of(text_with_variables(), 1),
           "process: program and arguments, as in [\"python3\", \"rig.py\"]; it uses the protocol of "
           "docs/reference/process-target.md on standard input and output")
      .key("folder", &ProcessSource::folder, existing_folder(),
           "process: working folder of the program; default: the experiment file's folder")
      .key("environment", &ProcessSource::environment, map_of("NAME", text_with_variables()),
           "process: environment variables of the program, in addition to those of lacuna")
      .key("start_limit", &ProcessSource::start_limit, number("s").above(0.0),
           "process: time limit until the program says hello")
      .key("trial_limit", &ProcessSource::trial_limit, number("s").above(0.0),
           "process: time that a trial may take beyond the duration of the test")
      .key("repeats", &ProcessSource::repeats, whole_number<int>(0, 1000),
           "process: how often `lacuna run` repeats a failed test before it takes another one")
      .key("pause", &ProcessSource::pause, number("s").at_least(0.0),
           "process: pause of `lacuna run` after a failed test")
      .key("copies", &ProcessSource::copies, whole_number<int>(1, 1000),
           "process: how many instances of the program may run at the same time; 1 for a rig, for which replicates "
           "then wait")
      .key("version", &ProcessSource::version, text(),
           "process: version of the target; change it when the target has changed, so that its earlier trials are left "
           "out");
}

namespace {

using KeysOfKinds = std::vector<std::pair<std::string, Shape>>;

/// A target of a plugin that did not come with the program has none of the keys of the others: where one is there,
/// the kind is misspelt.
void check_other_kind(const KeysOfKinds& kinds, const TomlNode& node, Reading& reading, const std::string& other) {
  std::vector<std::string> names;
  bool has_their_keys = false;
  for (const auto& [kind, shape] : kinds) {
    names.push_back(kind);
    for (const KeyShape& key : shape.keys) has_their_keys = has_their_keys || node.find(key.name) != nullptr;
  }
  if (has_their_keys)
    reading.problem_at(
        "kind", node.find("kind")->location,
        "must be \"recorded\", \"simulated\" or \"process\", but is " + toml_text(other) + did_you_mean(other, names));
}

/// Of each kind of target the keys that others do not have.
void check_kind(const TomlNode& node, Reading& reading, TargetSection& target) {
  const KeysOfKinds kinds = {{"recorded", recording_keys().value().shape},
                             {"simulated", simulated_keys().value().shape},
                             {"process", process_keys().value().shape}};
  const auto is_its_own = [&](const auto& kind) { return kind.first == target.kind; };
  if (std::none_of(kinds.begin(), kinds.end(), is_its_own)) return check_other_kind(kinds, node, reading, target.kind);
  for (const auto& [kind, shape] : kinds)
    for (const KeyShape& key : shape.keys) {
      const TomlNode* found = kind == target.kind ? nullptr : node.find(key.name);
      if (found) reading.problem_at(key.name, found->location, "is only used with kind = " + toml_text(kind));
    }
  std::string& robot = target.simulated.system.robot;
  if (target.kind == "simulated" && robot.empty() && node.find("file")) robot = "declared";
  if (target.kind == "process" && target.process.folder.empty()) target.process.folder = reading.directory();
  struct Need {
    const char *kind, *key, *complaint;
  };
  static constexpr Need kNeeds[] = {
      {"recorded", "files", "is missing: fit files (a list of at least 1, each a file's path)"},
      {"simulated", "robot", "is missing: the name of a robot plugin, or file = \"robot.toml\""},
      {"process", "command", "is missing: the program and its arguments, as in [\"python3\", \"rig.py\"]"}};
  const bool has_recording = target.kind == "recorded" && node.find("recording");
  for (const Need& need : kNeeds)
    if (target.kind == need.kind && !node.find(need.key) && !has_recording &&
        !(target.kind == "simulated" && node.find("file")))
      reading.problem_at(need.key, node.location, need.complaint);
}

}  // namespace

Table<TargetSection> target_keys() {
  return Table<TargetSection>()
      .key("kind", &TargetSection::kind, element_name(),
           "kind of target: recorded (measured files), simulated (a robot with values hidden from the search), process "
           "(a program, such as a rig's driver or another simulator), or the name of a target plugin, which has no "
           "further key")
      .merged(&TargetSection::recording, recording_keys())
      .merged(&TargetSection::simulated, simulated_keys())
      .merged(&TargetSection::process, process_keys())
      .check({"kind"}, check_kind);
}

}  // namespace lacuna
