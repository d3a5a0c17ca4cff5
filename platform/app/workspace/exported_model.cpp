#include "app/workspace/exported_model.h"

#include "config/edits/effects_editor.h"
#include "config/toml/toml_node.h"
#include "evaluation/model/model_definition.h"
#include "foundation/address.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr int kDigits = 6;

std::string interval_of(const FittedValue& value) {
  if (value.at_lower_bound || value.at_upper_bound) return "at a bound";
  if (!value.identified || !std::isfinite(value.standard_error)) return "not determined by the data";
  return fmt::format("95 %: {} to {}", format_quantity(value.lower_95, value.unit, kDigits),
                     format_quantity(value.upper_95, value.unit, kDigits));
}

std::string base_line(const ModelSection& model, bool has_base) {
  if (!has_base || model.base == RobotBase::as_written) return {};
  return fmt::format("base = \"{}\"\n", model.base == RobotBase::free ? "free" : "held");
}

std::string held_line(const ModelSection& model) {
  std::string list;
  for (const std::string& one : model.held) list += (list.empty() ? "" : ", ") + toml_text(one);
  return list.empty() ? "" : "held = [" + list + "]\n";
}

}  // namespace

std::string export_comment(const OpenExperiment& opened, int revision, const FitResult& fit) {
  std::string text = fmt::format("Identified by Lacuna: {}, revision {}\n", opened.experiment.name, revision);
  for (const FittedValue& value : fit.values)
    text += fmt::format("{} = {} ({})\n", value.address, format_quantity(value.value, value.unit, kDigits),
                        interval_of(value));
  return text;
}

std::string exported_model_toml(const std::string& comment, const std::filesystem::path& robot_file,
                                const ModelSection& model, const IdentifiedRobot& identified,
                                const ExportedRobot& exported, bool has_base) {
  std::string text = toml_comment(comment);
  for (const auto& [address, value] : identified.of_setups)
    text += fmt::format("# only for some recordings: {} = {}\n", address, toml_number(value));
  for (const std::string& sentence : exported.left_out) text += "# left out: " + sentence + "\n";
  text += fmt::format("\n[model]\nfile = {}\n", toml_text(robot_file.filename().string()));
  text += base_line(model, has_base) + held_line(model);
  std::string effects;
  for (const EffectEntry& effect : identified.effects) effects += "  " + effect_as_toml(effect) + ",\n";
  text += effects.empty() ? "effects = []\n" : "effects = [\n" + effects + "]\n";
  if (exported.set.empty()) return text;
  text += "\n[model.set]\n";
  for (const auto& [address, value] : exported.set)
    text += fmt::format("{} = {}\n", toml_text(address), toml_number(value));
  return text;
}

OpenExperiment experiment_of_revision(const CommonOptions& options, OpenExperiment now, int revision) {
  RevisionRecord record;
  {
    ResultRecorder recorder(options, now, options.seed.value_or(1), 1);
    const std::optional<StoredRevision> stored = recorder.store().revision(recorder.experiment(), revision);
    if (!stored)
      throw Error(fmt::format("--revision {}: {} has no such revision of {}; to list the revisions: lacuna history",
                              revision, recorder.file().string(), now.experiment.name));
    record = recorder.store().revision_record(stored->id);
    recorder.done();
  }
  ModelSection& model = now.experiment.model;
  model.effects = record.effects;
  model.free.clear();
  for (const FreeValueRecord& free : record.free)
    if (!is_of_effect(free.address) && without_setup(free.address) == free.address)
      model.free.push_back({free.address, free.lower, free.upper, free.start});
  now.definition = define_model(now.experiment, *now.catalog);
  now.model = compile(now.definition.structure, now.definition.engine);
  return now;
}

}  // namespace lacuna
