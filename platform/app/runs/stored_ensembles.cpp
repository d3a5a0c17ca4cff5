#include "app/runs/stored_ensembles.h"

#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMuchWorse = 2.0;  // times the error of the best, on the trials that both were fitted to

/// The genome's model with the values that are stored beside it: delays of sensors may be no genes.
ModelProposal model_of(const EeaStore& store, const EeaDefinition& definition, const EnsembleRow& row) {
  const std::optional<ModelRow> stored = store.model(row.model);
  if (!stored) throw Error("model " + std::to_string(row.model) + " of the ensemble is not in the database");
  ModelProposal model = definition.decode_model(stored->genome);
  for (std::size_t v = 0; v < std::min(model.values.size(), row.values.size()); ++v)
    if (std::isfinite(row.values[v])) model.values[v] = row.values[v];
  return model;
}

/// All that the trial measured, and replayed where the experiment says so, as far as models of that pass were held
/// against it.
ScoredTrial all_that_counted(const EeaDefinition& definition, const RunTrial& stored, int pass) {
  ScoredTrial observed = definition.observed(stored.drive, stored.trial);
  const Eigen::Index rows = definition.scored(stored.drive, stored.trial, pass).trial.measured.times.size();
  observed.trial.measured.times.conservativeResize(rows);
  observed.trial.measured.samples.conservativeResize(rows, Eigen::NoChange);
  return observed;
}

}  // namespace

StoredEnsembles::StoredEnsembles(const EeaStore& store, const EeaDefinition& definition,
                                 const std::vector<RunTrial>& trials, const Stop& stop)
    : definition_(definition), trials_(trials), stop_(stop) {
  for (PassRow& row : store.passes()) {
    Pass pass{std::move(row), {}};
    pass.ensemble.pass = pass.row.number;
    for (const EnsembleRow& member : pass.row.ensemble)
      if (member.score > kMuchWorse * pass.row.ensemble.front().score)
        ++pass.ensemble.refuted;
      else
        add_unless_copy(pass.ensemble, member.model, model_of(store, definition, member), definition.phenotypes);
    passes_.push_back(std::move(pass));
  }
}

bool StoredEnsembles::counts(const RunTrial& trial, const PassRow& pass) {
  if (!trial.row.test) return true;  // recorded
  const std::vector<int>& aside = pass.set_aside;
  return !trial.row.for_transfer && trial.row.number < pass.number &&
         std::find(aside.begin(), aside.end(), trial.row.number) == aside.end();
}

PassEnsemble StoredEnsembles::with_noise(const Pass& pass) const {
  std::vector<ScoredTrial> fitted;
  for (const RunTrial& trial : trials_)
    if (counts(trial, pass.row)) fitted.push_back(all_that_counted(definition_, trial, pass.row.number));
  PassEnsemble ensemble = pass.ensemble;
  std::uint64_t steps = 0;
  ensemble.noise = noise_of_readings(definition_, ensemble.models.front(), fitted, steps, stop_);
  return ensemble;
}

std::vector<HeldOutTrial> StoredEnsembles::held_out(int threads) const {
  std::vector<std::pair<const Pass*, const RunTrial*>> pairs;
  for (const Pass& pass : passes_)
    for (const RunTrial& trial : trials_)
      if (trial.row.test && trial.row.number == pass.row.number && !pass.ensemble.models.empty())
        pairs.emplace_back(&pass, &trial);
  std::vector<HeldOutTrial> held_out(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i, int) {
    stop_.throw_if_due();
    const auto& [pass, trial] = pairs[i];
    held_out[i] = held_against(definition_, with_noise(*pass), trial->row.number, as_new_trial(*trial), stop_);
  });
  return held_out;
}

}  // namespace lacuna
