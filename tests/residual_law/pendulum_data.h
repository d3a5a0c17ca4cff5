#pragma once

#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "plugins/built_catalog.h"
#include "search/fitted_models.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// The pendulum of the recordings as its model of first-steps.toml has it: 0.030 kg·m² about the hinge, 0.981 N·m at
/// 90°. Its mass, armature and damping (0 to 0.2 N·m·s/rad) are free.
inline constexpr double kModelInertia = 0.030;  // kg·m²

/// What a search is asked beside the recordings; see `EffectSearchTask`.
struct PendulumTask {
  std::vector<std::string> among = {};
  const KeptFits* known = nullptr;
  std::function<void(const KeptFits&)> keep = {};
};

/// Recordings of it as a search sees them, without a search.
class PendulumData {
 public:
  explicit PendulumData(std::vector<Trial> recordings, const PendulumTask& task = {})
      : experiment_(read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml")),
        trials_(std::move(recordings)) {
    experiment_.noise = {};
    experiment_.model.effects = {};
    data_ = std::make_shared<SearchData>(
        EffectSearchTask{.experiment = experiment_,
                         .catalog = built_catalog(),
                         .trials = trials_,
                         .values = define_model(experiment_, built_catalog()).start_values(),
                         .among = task.among,
                         .known = task.known,
                         .keep = task.keep});
  }
  PendulumData(const PendulumData&) = delete;
  PendulumData& operator=(const PendulumData&) = delete;

  const SearchData& data() const { return *data_; }

  std::shared_ptr<const SearchData> shared() const { return data_; }
  const Experiment& experiment() const { return experiment_; }
  const std::vector<Trial>& trials() const { return trials_; }

  /// A model, fitted on the deciding lengths, and linearised there.
  struct Fitted {
    FittedModel model;
    LinearPrediction linear;
  };
  Fitted fitted(const AugmentedModel& model) const {
    const ModelContext context = data_->bench_for(model);
    LadderPredictions predictions(data_->deciding(), context.predictor(), context.space(), data_->starts());
    Fitted result;
    result.model.model = model;
    std::vector<double> values = model.definition.start_values();
    if (data_->timing()) values.push_back(0.0);
    const Eigen::VectorXd start = context.space().to_coordinates(values);
    result.model.fit = descend(predictions, predictions.at_smoothed_starts(start), 10);
    result.linear = *predictions.linearise(result.model.fit.point);
    return result;
  }
  /// The model as it is.
  Fitted fitted() const { return fitted(data_->plain()); }

 private:
  Experiment experiment_;
  std::vector<Trial> trials_;
  std::shared_ptr<const SearchData> data_;
};

/// Two recordings of one truth.
inline std::vector<Trial> two_recordings(PendulumTruth truth) {
  truth.inertia = kModelInertia;
  return {recorded(truth, "one.csv", multisine, 3.0, 3), recorded(truth, "two.csv", steps, 3.0, 4)};
}

}  // namespace lacuna
