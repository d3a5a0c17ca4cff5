#include "config/experiment_reader.h"

#include "config/schema/experiment_schema.h"
#include "config/toml/locations.h"
#include "config/overrides.h"
#include "config/toml/path_variables.h"
#include "config/robots/robot_reader.h"
#include "config/toml/text_file.h"
#include "config/toml/toml_parser.h"
#include "foundation/digest.h"

namespace lacuna {
namespace {

constexpr const char* kOwnEnding = ".toml";

void append(const BadInput& bad, ProblemList& problems) {
  for (const Problem& problem : bad.problems()) problems.add(problem);
}

/// The robot is read even where the rest has problems, so that its own are reported with them.
void read_declared_robot(const TomlNode& tree, const std::string& section, const std::filesystem::path& directory,
                         ModelSection& into, ProblemList& problems) {
  const TomlNode* system = tree.find(section);
  const TomlNode* file = system ? system->find("file") : nullptr;
  if (!file || file->kind != TomlNode::Kind::text || file->text.empty()) return;
  std::filesystem::path path;
  try {
    path = resolve_existing_file(file->text, directory);
  } catch (const Error&) {
    return;  // reported with the key
  }
  try {
    const std::string text = read_text_file(path);
    into.file_digest = sha256(text);
    if (path.extension() != kOwnEnding) {
      into.foreign_text = text;
      return;
    }
    into.declared = read_robot_text(text, path, &into.robot_places);
  } catch (const BadInput& bad) {
    append(bad, problems);
  }
}

/// `engine.contact.friction` stands for `model.set.contact.friction` and the target's, and is found under all of them.
template <class Entries>
void alias_contact(Entries& entries) {
  const std::string prefix = "engine.contact.";
  Entries aliases;
  for (const auto& [key, entry] : entries)
    for (const char* set : {"model.set.contact.", "target.set.contact."})
      if (key.starts_with(prefix)) aliases[set + key.substr(prefix.size())] = entry;
  entries.merge(aliases);
}

}  // namespace

Experiment read_experiment_text(const std::string& text, const std::filesystem::path& file,
                                const std::vector<std::string>& overrides) {
  TomlNode tree = parse_toml(text, file.string());
  ProblemList problems;
  apply_overrides(tree, overrides, problems);
  Reading reading(problems, file.parent_path());
  Experiment experiment;
  experiment.file = file;
  experiment.text = text;
  experiment.overrides = overrides;
  static const Value<Experiment> kKeys = experiment_keys().value();
  kKeys.read(tree, reading, experiment);
  read_declared_robot(tree, "model", file.parent_path(), experiment.model, problems);
  read_declared_robot(tree, "target", file.parent_path(), experiment.target.simulated.system, problems);
  problems.throw_if_any();
  experiment.locations = locations_of(tree);
  experiment.written_units = reading.written_units();
  alias_contact(experiment.locations);
  alias_contact(experiment.written_units);
  return experiment;
}

Experiment read_experiment(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_experiment_text(read_text_file(file), file, overrides);
}

}  // namespace lacuna
