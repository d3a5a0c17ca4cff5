#include "eea/definition/eea_definition.h"

#include "evaluation/model/channel_choice.h"
#include "evaluation/named_controller.h"
#include "evaluation/model/proposed_model.h"
#include "foundation/address.h"
#include "foundation/unit.h"
#include "storage/eea/eea_records.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace lacuna {
namespace {

constexpr int kStructureDraws = 100;

/// The first seconds of the series.
TimeSeries until(TimeSeries series, double seconds) {
  constexpr double kRounding = 1e-9;  // s
  Eigen::Index rows = 0;
  while (rows < series.times.size() && series.times(rows) <= series.times(0) + seconds + kRounding) ++rows;
  series.times.conservativeResize(rows);
  series.samples.conservativeResize(rows, Eigen::NoChange);
  return series;
}

}  // namespace

EeaDefinition::EeaDefinition(const Experiment& experiment, const PluginCatalog& catalog, ModelDefinition of_model,
                             bool takes_tests)
    : model(std::move(of_model)),
      phenotypes(model),
      compiled(compile(model.structure, model.engine)),
      model_space{model.structure.robot, {model.free.begin(), model.free.end()}, model_effects(model)},
      gene_space(model_space),
      passes(takes_tests ? experiment.passes : 1),
      seeds(experiment.estimation.seeds),
      restarts(experiment.estimation.restarts),
      rivals(experiment.estimation.rivals),
      replay(experiment.estimation.replay),
      horizons(experiment.estimation.horizons),
      challenge(experiment.estimation.challenge),
      patience(experiment.estimation.patience),
      stop_below(experiment.exploration.stop_below),
      approximate(takes_tests && experiment.model.approximate),
      target_is_program(experiment.target.kind == "process"),
      abandon(experiment.estimation.abandon),
      reuse(experiment.estimation.reuse) {
  Complaints complaints(experiment);
  find_profiled(experiment.estimation, complaints);
  define_estimation(experiment, catalog, complaints);
  check_rivals(complaints);
  check_horizons(takes_tests, complaints);
  ensemble = static_cast<std::size_t>(experiment.estimation.ensemble);
  if (takes_tests) define_exploration(experiment, catalog, complaints);
  complaints.throw_if_any();
}

/// Alternative models of other structures need several structures and several restarts.
void EeaDefinition::check_rivals(Complaints& complaints) const {
  if (!rivals) return;
  if (restarts < 2)
    complaints.add("estimation.rivals",
                   "the second restart looks for the first other structure; write restarts = 2 or more");
  if (!estimation.breeder) return;
  std::set<std::string> structures;
  RandomStream random(std::array<std::uint64_t, 1>{0});
  for (int i = 0; i < kStructureDraws && structures.size() < 2; ++i) try {
      structures.insert(decode_model(estimation.breeder->random(random)).structure);
    } catch (const Error&) {
      return;  // a search reports genomes that cannot be decoded
    }
  if (structures.size() < 2)
    complaints.add("estimation.rivals",
                   "all models of the encoding " + model_encoding.origin.name +
                       " have the same structure, so there is no other one to look for; leave rivals out, or "
                       "take an encoding such as parameters_and_effects or morphology");
}

void EeaDefinition::check_horizons(bool takes_tests, Complaints& complaints) const {
  const double period = std::max(model.engine.step, model.engine.control_period);
  if (!takes_tests && horizons.size() > 1)
    complaints.add("estimation.horizons", "a recorded target is explained in one pass; give one horizon");
  for (std::size_t i = 0; i < horizons.size(); ++i) {
    const std::string key = "estimation.horizons[" + std::to_string(i) + "]";
    if (takes_tests && horizons[i] < period)
      complaints.add(key, format_quantity(horizons[i], "s") + " is less than one control period, " +
                              format_quantity(period, "s") +
                              ", so only the initial state would count; give a longer horizon");
    if (i > 0 && horizons[i] < horizons[i - 1])
      complaints.add(key, format_quantity(horizons[i], "s") + " is less than in the pass before, " +
                              format_quantity(horizons[i - 1], "s") + "; horizons must grow");
  }
}

/// Delays of sensors that are not genes.
void EeaDefinition::find_profiled(const EstimationSection& estimate, Complaints& complaints) {
  std::vector<bool> is_profiled(model_space.free.size(), false);
  for (std::size_t i = 0; i < estimate.profiled.size(); ++i) {
    const std::string key = "estimation.profiled[" + std::to_string(i) + "]";
    bool found = false;
    for (std::size_t v = 0; v < model_space.free.size(); ++v) {
      const FreeParameter& free = model_space.free[v];
      if (!matches(estimate.profiled[i], free.address)) continue;
      found = true;
      if (!matches("sensor.*.delay", free.address))
        complaints.add(key,
                       free.address + " is not a delay of a sensor; only such delays can be found without simulating");
      else if (free.lower > 0.0)
        complaints.add(key, free.address + " begins at " + format_quantity(free.lower, "s") +
                                ", but models are simulated without it; let its range begin at 0 s");
      else
        is_profiled[v] = true;
    }
    if (!found) complaints.add(key, "no free value has the name \"" + estimate.profiled[i] + "\"; see [model.free]");
  }
  if (!estimate.profiled.empty() && !estimate.replay)
    complaints.add("estimation.profiled",
                   "delays change what a model with a controller does, because the controller responds to delayed "
                   "readings; write replay = true");
  gene_space.free.clear();
  for (std::size_t v = 0; v < model_space.free.size(); ++v)
    if (is_profiled[v])
      profiled.push_back(v);
    else
      gene_space.free.push_back(model_space.free[v]);
  for (ModelEffect& effect : gene_space.effects)  // after all values of the robot come those of the effects
    for (std::size_t& v : effect.values) v -= profiled.size();
}

ModelProposal EeaDefinition::decode_model(const Genome& genome) const {
  ModelProposal decoded = guarded_call(model_encoding.origin, "decode", [&] {
    return model_encoding->decode(gene_space, model_encoding.parameters, genome);
  });
  if (const std::string fault = misfit(decoded, gene_space); !fault.empty())
    throw Error(to_string(model_encoding.origin) + ": " + fault + "; this is a fault of the plugin: repair it");
  for (const std::size_t v : profiled)  // in ascending order, so that each insertion is at its final place
    decoded.values.insert(decoded.values.begin() + static_cast<std::ptrdiff_t>(v), 0.0);
  for (const std::size_t effect : decoded.without)
    for (const std::size_t v : model_space.effects[effect].values) decoded.values[v] = kNotKnown;
  return decoded;
}

Test EeaDefinition::decode_test(const Genome& genome) const {
  Test test = guarded_call(test_encoding.origin, "decode",
                           [&] { return test_encoding->decode(test_space, test_encoding.parameters, genome); });
  test = with_named_controller(std::move(test), test_encoding.origin);
  return seen_channels.empty() ? test : with_view(std::move(test), seen_channels);
}

Test EeaDefinition::drive_of(Test test, const Trial& trial) const {
  if (target_is_program && std::holds_alternative<CommandSeries>(test.drive)) test.drive = trial.commands;
  return test;
}

ScoredTrial EeaDefinition::scored(Test drive, Trial trial, int pass) const {
  if (!scored_channels.empty()) trial = with_channels(std::move(trial), scored_channels);
  if (!horizons.empty()) trial.measured = until(std::move(trial.measured), horizon(pass));
  return observed(std::move(drive), std::move(trial));
}

double EeaDefinition::horizon(int pass) const {
  if (horizons.empty()) return std::numeric_limits<double>::infinity();
  const auto last = static_cast<int>(horizons.size()) - 1;
  return horizons[static_cast<std::size_t>(std::clamp(pass - 1, 0, last))];
}

ScoredTrial EeaDefinition::observed(Test drive, Trial trial) const {
  if (replay) drive.drive = trial.commands;
  return {std::move(drive), std::move(trial), 0};
}

}  // namespace lacuna
