#include "contacts/engine_model.h"

#include "config/experiment_reader.h"
#include "evaluation/model/model_definition.h"
#include "foundation/address.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kLowest = 0.4, kHighest = 2.5;  ///< bounds of the free value, times the nominal one

const lacuna::PluginCatalog& catalog() {
  static const lacuna::PluginCatalog all(lacuna::plugin_search_path({}));
  return all;
}

/// A number as TOML takes a float.
std::string number(double value) {
  const std::string text = fmt::format("{:.10g}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string robot_line(const ContactRig& rig) {
  return rig.robot.empty() ? fmt::format("robot = \"{}\"", rig.name) : "file = \"robot.toml\"";
}

std::string effect_text(const SizedContactLaw& one) {
  std::string text = fmt::format("{{ effect = \"{}\"", one.law.effect);
  if (!one.law.where.empty()) text += fmt::format(", where = \"{}\"", one.law.where);
  return text + fmt::format(", start = {{ {} = {}{}{} }} }}", one.law.parameter, number(one.value),
                            one.law.others.empty() ? "" : ", ", one.law.others);
}

std::string ground_text(const ContactGround& ground) {
  if (std::isinf(ground.stiffness)) return {};
  return fmt::format("\n[engine.contact]\nstiffness = {}\ndamping = {}\n", number(ground.stiffness),
                     number(ground.damping));
}

/// The rig as a model with one free value.
lacuna::ModelDefinition define(const ContactRig& rig, const std::filesystem::path& folder, Integration integration,
                               const std::vector<SizedContactLaw>& laws) {
  const std::string text = fmt::format("[experiment]\nname = \"rig\"\n[target]\nkind = \"simulated\"\n{}\n{}",
                                       robot_line(rig), model_text(rig, integration, laws));
  return lacuna::define_model(lacuna::read_experiment_text(text, folder / "rig.toml"), catalog());
}

lacuna::CommandSeries command_series(const ContactRig& rig, const Samples& commands, double interval) {
  lacuna::CommandSeries series;
  const auto rows = static_cast<Eigen::Index>(commands.front().size());
  series.series.times = Eigen::VectorXd::LinSpaced(rows, 0.0, static_cast<double>(rows - 1) * interval);
  series.series.samples.resize(rows, static_cast<Eigen::Index>(commands.size()));
  for (std::size_t d = 0; d < commands.size(); ++d) {
    series.series.channels.push_back({rig.drives[d].name, rig.drives[d].unit});
    series.series.samples.col(static_cast<Eigen::Index>(d)) =
        Eigen::Map<const Eigen::VectorXd>(commands[d].data(), rows);
  }
  return series;
}

/// Positions that the rig's file gives for the start; what it does not name starts at zero.
lacuna::StartState start_of(const ContactRig& rig, const lacuna::CompiledModel& model) {
  lacuna::StartState start;
  for (const lacuna::Coordinate& coordinate : model.coordinates()) {
    const auto given = std::find_if(rig.starts.begin(), rig.starts.end(),
                                    [&](const ContactStart& one) { return "joint." + one.joint == coordinate.name; });
    start.positions.push_back(given == rig.starts.end() ? 0.0 : given->position);
    start.velocities.push_back(0.0);
  }
  return start;
}

}  // namespace

struct EngineModel::Compiled {
  std::vector<double> values;
  std::unique_ptr<lacuna::CompiledModel> model;
  std::unique_ptr<lacuna::Workspace> workspace;
  lacuna::StartState start;
  std::vector<Eigen::Index> columns;  ///< of the rig's channels
};

EngineModel::EngineModel(const ContactRig& rig, const std::filesystem::path& folder, Integration integration,
                         const std::vector<SizedContactLaw>& laws)
    : rig_(rig), compiled_(std::make_unique<Compiled>()) {
  const lacuna::ModelDefinition definition = define(rig, folder, integration, laws);
  compiled_->values = definition.start_values();
  compiled_->model = lacuna::compile(definition.structure, definition.engine);
  compiled_->workspace = compiled_->model->make_workspace();
  compiled_->start = start_of(rig, *compiled_->model);
  const std::vector<lacuna::Channel>& channels = compiled_->model->channels();
  for (const ContactChannel& wanted : rig.channels) {
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const lacuna::Channel& one) { return one.name == wanted.name; });
    if (found == channels.end()) throw std::logic_error(rig.name + " has no channel " + wanted.name);
    compiled_->columns.push_back(found - channels.begin());
  }
}

EngineModel::~EngineModel() = default;

Samples EngineModel::readings(double free_value, const Samples& commands, double command_interval) const {
  const auto rows = static_cast<Eigen::Index>(rig_.samples());
  const Eigen::VectorXd times = Eigen::VectorXd::LinSpaced(rows, 0.0, rig_.duration);
  lacuna::SimulationOptions options;
  options.start = compiled_->start;
  options.end_time = rig_.duration;
  options.output_times = {times.data(), static_cast<std::size_t>(rows)};
  std::vector<double> values = compiled_->values;
  values.front() = free_value;
  lacuna::SimulationResult result;
  compiled_->model->simulate(values, {command_series(rig_, commands, command_interval), rig_.duration, {}}, options,
                             *compiled_->workspace, result);
  if (result.ending != lacuna::Ending::completed) throw std::runtime_error(result.reason);
  Samples readings;
  for (std::size_t c = 0; c < rig_.channels.size(); ++c) {
    const Eigen::VectorXd column = result.readings.samples.col(compiled_->columns[c]);
    std::vector<double>& values_of = readings.emplace_back(column.begin(), column.end());
    if (rig_.channels[c].touch())
      for (double& value : values_of) value = value < 0.0 ? -1.0 : 1.0;
  }
  return readings;
}

std::string model_text(const ContactRig& rig, Integration integration, const std::vector<SizedContactLaw>& laws) {
  std::vector<std::string> effects;
  for (const SizedContactLaw& one : laws) effects.push_back(effect_text(one));
  const bool truth = integration == Integration::truth;
  return fmt::format(
      "[model]\n{}\neffects = [{}]\n\n[model.free]\n\"{}\" = [{}, {}]\n\n[engine]\nstep = {}\nsubsteps = {}\n{}",
      robot_line(rig), fmt::join(effects, ", "), rig.free, number(kLowest * rig.nominal),
      number(kHighest * rig.nominal), number(truth ? rig.step / 10.0 : rig.step), rig.substeps,
      ground_text(truth ? rig.real : rig.believed));
}

}  // namespace hidden_effects
