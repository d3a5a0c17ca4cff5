#include "residual_law/force_pulses.h"

#include "foundation/statistics.h"
#include "fitting/floor/disturbance.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr Eigen::Index kMostPulses = 12;  ///< of a stretch
constexpr double kWantedChange = 0.5;     ///< of the residuals: wanted change by one pulse
constexpr int kSizeRounds = 4;

/// Stretches of one length, which do not overlap.
struct OneLength {
  PredictionLadder ladder;
  std::vector<std::size_t> numbers;  ///< of the stretches in the whole ladder
  PredictionPoint point;
  Eigen::Index pulses = 0;
};

std::pair<Eigen::Index, Eigen::Index> samples_of_pulse(const PredictedStretch& stretch, Eigen::Index pulse,
                                                       Eigen::Index pulses) {
  const Eigen::Index size = stretch.stretch.size() - 1;  // a force that begins at the last sample changes no reading
  return {size * pulse / pulses, size * (pulse + 1) / pulses};
}

class Pulser {
 public:
  Pulser(const SearchData& data, const FittedModel& model, const JointCourse& joint)
      : data_(data),
        model_(model),
        joint_{joint.joint, "law_on_" + joint.joint, 1.0},
        disturbed_(compile_disturbed(model.model.definition, {joint_})),
        space_(model.model.definition.free) {}

  /// By stretch; false where a stretch cannot be simulated.
  bool responses(const OneLength& one, ForcePulses& all) {
    std::vector<Eigen::VectorXd> calm, pushed;
    if (!residuals(one, 0, 0.0, calm)) return false;
    double force = 1e-3;
    for (int round = 0; round < kSizeRounds; ++round) {
      if (!residuals(one, 0, force, pushed)) return false;
      for (std::size_t k = 0; k < pushed.size(); ++k) pushed[k] -= calm[k];
      const double change = root_mean_square(pushed);
      const double wanted = kWantedChange * std::max(1.0, root_mean_square(calm));
      const double next = change > 0.0 ? force * wanted / change : 100.0 * force;
      const bool is_near = next < 3.0 * force && next > force / 3.0;
      force = std::clamp(next, 1e-9, 1e6);
      if (is_near) break;
    }
    for (std::size_t k = 0; k < one.numbers.size(); ++k)
      all.responses[one.numbers[k]] = Eigen::MatrixXd::Zero(calm[k].size(), one.pulses);
    for (Eigen::Index pulse = 0; pulse < one.pulses; ++pulse) {
      if (!residuals(one, pulse, force, pushed)) return false;
      for (std::size_t k = 0; k < one.numbers.size(); ++k)
        all.responses[one.numbers[k]].col(pulse) = (calm[k] - pushed[k]) / force;
    }
    return true;
  }

 private:
  bool residuals(const OneLength& one, Eigen::Index pulse, double force, std::vector<Eigen::VectorXd>& found) {
    std::vector<Trial> trials = data_.task().trials;
    for (std::size_t t = 0; t < trials.size(); ++t)
      trials[t].commands = with_force_pulses(trials[t].commands, joint_, intervals(one, t, pulse), force);
    const TrialPredictor predictor(*disturbed_, std::move(trials), data_.task().work);
    LadderPredictions predictions(one.ladder, predictor, space_, data_.starts(),
                                  changes_readings(model_.model.definition));
    return predictions.residuals(one.point, found);
  }

  std::vector<std::pair<double, double>> intervals(const OneLength& one, std::size_t trial, Eigen::Index pulse) const {
    std::vector<std::pair<double, double>> found;
    const Eigen::VectorXd& times = data_.task().trials[trial].measured.times;
    for (const PredictedStretch& stretch : one.ladder.stretches) {
      if (stretch.stretch.trial != trial) continue;
      const auto [first, end] = samples_of_pulse(stretch, pulse, one.pulses);
      if (first < end) found.emplace_back(times(stretch.stretch.first + first), times(stretch.stretch.first + end));
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  const SearchData& data_;
  const FittedModel& model_;
  DisturbedJoint joint_;
  std::unique_ptr<CompiledModel> disturbed_;
  ParameterSpace space_;
};

OneLength of_length(const PredictionLadder& ladder, std::size_t length, const PredictionPoint& fitted,
                    Eigen::Index values) {
  OneLength one{ladder, {}, {fitted.values.head(values), {}}, 0};
  one.ladder.stretches.clear();
  Eigen::Index longest = 0;
  for (std::size_t k = 0; k < ladder.stretches.size(); ++k) {
    if (ladder.stretches[k].length != length) continue;
    one.ladder.stretches.push_back(ladder.stretches[k]);
    one.numbers.push_back(k);
    one.point.starts.push_back(fitted.starts[k]);
    longest = std::max(longest, ladder.stretches[k].stretch.size() - 1);
  }
  one.pulses = std::min(kMostPulses, longest);
  return one;
}

}  // namespace

ForcePulses force_pulses(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder,
                         const JointCourse& joint) {
  ForcePulses all;
  all.responses.resize(ladder.stretches.size());
  all.samples.resize(ladder.stretches.size());
  Pulser pulser(data, model, joint);
  const auto values = static_cast<Eigen::Index>(model.model.definition.free.size());
  for (std::size_t length = 0; length < ladder.lengths.size(); ++length) {
    const OneLength one = of_length(ladder, length, model.fit.point, values);
    if (one.numbers.empty()) continue;
    if (!pulser.responses(one, all)) return {};
    for (const std::size_t k : one.numbers)
      for (Eigen::Index pulse = 0; pulse < one.pulses; ++pulse)
        all.samples[k].push_back(samples_of_pulse(ladder.stretches[k], pulse, one.pulses));
  }
  return all;
}

}  // namespace lacuna
