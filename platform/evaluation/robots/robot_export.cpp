#include "evaluation/robots/robot_export.h"

#include "config/robots/robot_reader.h"
#include "config/robots/robot_writer.h"
#include "config/toml/text_file.h"
#include "config/toml/toml_node.h"
#include "evaluation/robots/robot_comparison.h"
#include "evaluation/robots/robot_files.h"
#include "foundation/address.h"
#include "foundation/processes/guarded_call.h"
#include "foundation/text/problem.h"

#include <lacuna/error.h>
#include <lacuna/robot_format.h>

#include <fmt/format.h>

#include <optional>

namespace lacuna {
namespace {

constexpr const char* kToml = "toml";

/// The model's own file, where it is of that format.
std::optional<std::string> original_text(const ModelSection& model, const std::string& format,
                                         const PluginCatalog& catalog) {
  if (model.file.empty()) return std::nullopt;
  const std::string text = read_text_file(model.file);
  const bool is_toml = model.file.extension() == ".toml";
  if (format == kToml) return is_toml ? std::optional(text) : std::nullopt;
  if (is_toml || robot_format_of(model.file, text, catalog) != format) return std::nullopt;
  return text;
}

/// A model of several files is written as one.
bool stands_alone(const ModelSection& model) { return model.parts.empty(); }

/// The robot of a text as an experiment beside it would read it.
RobotSpec read_back(const std::string& text, const std::string& format, const ModelSection& model,
                    const std::filesystem::path& file, const PluginCatalog& catalog) {
  Experiment experiment;
  experiment.file = file;
  experiment.model.file = file;
  experiment.model.held = model.held;
  if (format == kToml) {
    experiment.model.declared = read_robot_text(text, file);
  } else {
    experiment.model.base = model.base;
    experiment.model.foreign_text = text;
  }
  read_robot_files(experiment, catalog);
  return *experiment.model.declared;
}

/// The robot file's text with other numbers; nothing where it cannot be edited in this way.
std::optional<std::string> edited_toml(const std::string& original, const RobotSpec& robot, const ModelSection& model,
                                       const std::filesystem::path& file, const PluginCatalog& catalog) {
  try {
    const RobotSpec before = read_back(original, kToml, model, file, catalog);
    std::vector<std::pair<std::string, double>> changed;
    for (const auto& [address, value] : compare_robots(robot, before).set) changed.emplace_back(address, value);
    std::string text = with_robot_values(original, robot, changed);
    const RobotComparison after = compare_robots(robot, read_back(text, kToml, model, file, catalog));
    if (after.set.empty()) return text;
  } catch (const Error&) {
    return std::nullopt;
  }
  return std::nullopt;
}

void write_toml(const RobotSpec& robot, const std::optional<std::string>& original, const ModelSection& model,
                const std::string& comment, const std::filesystem::path& file, const PluginCatalog& catalog,
                ExportedRobot& exported) {
  if (original)
    if (const std::optional<std::string> edited = edited_toml(*original, robot, model, file, catalog)) {
      exported.text = toml_comment(comment) + *edited;
      exported.keeps_original = true;
      return;
    }
  exported.text = robot_toml(robot, comment);
}

void write_by_plugin(const RobotSpec& robot, const std::string& format, const std::optional<std::string>& original,
                     const ModelSection& model, const std::string& comment, const std::filesystem::path& file,
                     const PluginCatalog& catalog, ExportedRobot& exported) {
  RobotToWrite wanted{robot, std::nullopt, comment};
  if (original && stands_alone(model)) {
    wanted.original = RobotText{model.file.filename().string(), *original, model.base, nullptr};
    exported.keeps_original = true;
  }
  const RobotFormat& writer = catalog.get<RobotFormat>(format);
  WrittenRobot written =
      guarded_call(catalog.origin<RobotFormat>(format), "write", [&] { return writer.write(wanted); });
  ProblemList problems;
  for (const RobotFileProblem& problem : written.problems) problems.add({file.string(), 0, 0}, problem.text);
  problems.throw_if_any();
  exported.text = std::move(written.text);
  for (const RobotRemark& remark : written.remarks) exported.left_out.push_back(remark.text);
}

}  // namespace

ExportedRobot export_robot(const RobotSpec& robot, const std::string& format, const ModelSection& model,
                           const std::string& comment, const std::filesystem::path& file,
                           const PluginCatalog& catalog) {
  ExportedRobot exported;
  const std::optional<std::string> original = original_text(model, format, catalog);
  if (format == kToml)
    write_toml(robot, original, model, comment, file, catalog, exported);
  else
    write_by_plugin(robot, format, original, model, comment, file, catalog, exported);
  RobotComparison back = compare_robots(robot, read_back(exported.text, format, model, file, catalog));
  exported.set = std::move(back.set);
  exported.left_out.insert(exported.left_out.end(), back.other.begin(), back.other.end());
  return exported;
}

}  // namespace lacuna
