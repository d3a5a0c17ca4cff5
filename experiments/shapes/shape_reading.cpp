#include "shapes/shape_reading.h"

#include "app/runs/open_stored_run.h"
#include "shapes/trilateration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

namespace lacuna {
namespace {

/// The runs of one experiment, and the experiment itself.
class ShapeReading {
 public:
  ShapeReading(Database& database, const std::vector<EeaRunListing>& runs, OpenStoredRun stored)
      : runs_(runs), stored_(std::move(stored)), definition_(stored_.opened->definition()) {
    for (const EeaRunListing& run : runs) {
      stores_.push_back(std::make_unique<EeaStore>(database, unused_, run.run, ExperimentId{}));
      study_.runs.push_back(stores_.back()->passes());
      study_.seconds += std::isfinite(run.seconds) ? run.seconds : 0.0;
    }
    study_.experiment = runs.front().experiment;
  }

  ShapeStudy read() {
    read_random_models();
    const std::size_t typical = typical_run(study_.runs);
    study_.typical = runs_[typical].run.value;
    read_progress(*stores_[typical]);
    read_samples(*stores_[typical], study_.runs[typical]);
    trilaterate();
    return std::move(study_);
  }

 private:
  const RobotSpec& target() const { return stored_.opened->target()->structure.robot; }

  double distance_of(const ModelProposal& model) const {
    const Chosen<ObjectiveMetric>& metric = *definition_.objective;
    const std::vector<double> unknown(definition_.model.free.size(), kNotKnown);
    for (const ObjectiveScore& score :
         metric->score(definition_.model_space, model, {unknown, target()}, metric.parameters))
      if (score.name == kPartDistance) return score.value;
    throw Error(std::string("the objective metric part_distance has no value of ") + kPartDistance);
  }

  RobotSpec robot_of(const Genome& genome) const {
    const ModelProposal model = definition_.decode_model(genome);
    return model.robot ? *model.robot : definition_.model.structure.robot;
  }

  /// What the first pass of each run began with.
  void read_random_models() {
    double sum = 0.0, below = 0.0;
    for (const std::unique_ptr<EeaStore>& store : stores_)
      for (const ModelRow& row : store->models(1)) {
        if (row.generation > 0) break;
        const ModelProposal model = definition_.decode_model(row.genome);
        sum += distance_of(model);
        below += model.robot && starts_below(*model.robot, target()) ? 1.0 : 0.0;
        ++study_.random_models;
      }
    study_.random_distance = sum / static_cast<double>(study_.random_models);
    study_.below_ground = below / static_cast<double>(study_.random_models);
  }

  /// Scores of different passes are means over different trials, so each pass starts again.
  void read_progress(const EeaStore& store) {
    double generations = 0.0;
    for (const PassRow& pass : store.passes()) {
      const std::vector<ModelRow> models = store.models(pass.number);
      ProgressPoint best{0.0, kInfinity, kNotKnown, pass.number};
      for (std::size_t i = 0; i < models.size(); ++i) {
        if (models[i].kind == ScoreKind::full && models[i].score < best.score)
          best = {0.0, models[i].score, distance_of(definition_.decode_model(models[i].genome)), pass.number};
        if (i + 1 < models.size() && models[i + 1].generation == models[i].generation) continue;
        best.generations = ++generations;
        if (std::isfinite(best.score)) study_.progress.push_back(best);
      }
    }
  }

  void read_samples(const EeaStore& store, const std::vector<PassRow>& passes) {
    const std::vector<ModelRow> first = store.models(1);
    for (std::size_t i = 0; i < std::min<std::size_t>(2, first.size()); ++i)
      study_.samples.push_back({fmt::format("random model {}", i + 1), robot_of(first[i].genome)});
    for (const PassRow& pass : passes) {
      const bool drawn = pass.number <= 2 || pass.number == passes.back().number;
      if (drawn && pass.best_model)
        study_.samples.push_back(
            {fmt::format("pass {}: e_o {}", pass.number, distance_text(objective_of(pass, kPartDistance))),
             robot_of(store.model(*pass.best_model)->genome)});
    }
    study_.samples.push_back({"target", target()});
  }

  void trilaterate() {
    double sum = 0.0;
    for (const std::unique_ptr<EeaStore>& store : stores_) {
      const auto centres = trilaterated_centres(target(), store->trials());
      if (!centres) return;
      double distance = 0.0;
      for (std::size_t i = 0; i < target().bodies.size(); ++i)
        distance += (centres->row(static_cast<Eigen::Index>(i)).transpose() - target().bodies[i].position).norm();
      sum += distance / static_cast<double>(target().bodies.size());
    }
    study_.trilaterated = sum / static_cast<double>(stores_.size());
  }

  const std::vector<EeaRunListing>& runs_;
  OpenStoredRun stored_;
  const EeaDefinition& definition_;
  std::mutex unused_;
  std::vector<std::unique_ptr<EeaStore>> stores_;
  ShapeStudy study_;
};

/// Whether its runs say how far parts are from the target's: a simulated target, and the objective metric
/// `part_distance`.
bool speaks_of_parts(const OpenEeaRun& opened) {
  const std::optional<Chosen<ObjectiveMetric>>& objective = opened.definition().objective;
  return objective && objective->origin.name == "part_distance" && opened.target();
}

}  // namespace

std::optional<ShapeStudy> read_shape_study(Database& database, const std::vector<EeaRunListing>& runs,
                                           const std::vector<std::filesystem::path>& plugin_paths) {
  OpenStoredRun stored = open_stored(database, runs.front(), plugin_paths);
  if (!speaks_of_parts(*stored.opened)) return std::nullopt;
  return ShapeReading(database, runs, std::move(stored)).read();
}

}  // namespace lacuna
