#include "diagnosis/noise/force_responses.h"

#include "evaluation/trial_predictor.h"
#include "fitting/disturbance.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace lacuna {
namespace {

constexpr double kShortestPulse = 0.025;  // s
constexpr double kMostPulses = 120.0;
constexpr double kWantedChange = 0.5;  // of the residual, by one pulse
constexpr int kSizeRounds = 4;

using Interval = std::pair<double, double>;

/// Pulses of one joint in all segments, and what they do.
class Pulser {
 public:
  Pulser(const ModelDefinition& definition, const ShootingProblem& problem, const RowBins& bins, const FitPoint& point,
         const std::vector<double>& values, const DisturbedJoint& joint, double width)
      : problem_(problem),
        bins_(bins),
        point_(point),
        values_(values),
        joint_(joint),
        width_(width),
        model_(compile_disturbed(definition, {joint})) {}

  /// Change of the prediction by segment, bins × 1, per unit force; pulse `number` of each segment.
  std::vector<Eigen::VectorXd> response(int number, double force) const {
    std::vector<Trial> trials = problem_.predictor().trials();
    for (std::size_t trial = 0; trial < trials.size(); ++trial)
      trials[trial].commands = with_force_pulses(trials[trial].commands, joint_, intervals(trial, number), force);
    const std::vector<Eigen::MatrixXd> with = predictions(TrialPredictor(*model_, std::move(trials), 1));
    if (calm_.empty()) return {};
    std::vector<Eigen::VectorXd> change;
    for (std::size_t k = 0; k < with.size(); ++k) {
      if (with[k].size() == 0 || calm_[k].size() == 0)
        change.emplace_back(Eigen::VectorXd::Zero(bins_.rows(k)));
      else
        change.emplace_back((with[k] - calm_[k]) / force);
    }
    return change;
  }

  /// Simulates without force, then finds a force whose pulse changes the prediction by half of `residual` (RMS).
  double size(double residual) {
    std::vector<Trial> trials = problem_.predictor().trials();
    for (Trial& trial : trials) trial.commands = with_force_pulses(trial.commands, joint_, {}, 0.0);
    calm_ = predictions(TrialPredictor(*model_, std::move(trials), 1));
    double force = 1e-3;
    for (int round = 0; round < kSizeRounds; ++round) {
      double squares = 0.0;
      for (const Eigen::VectorXd& change : response(0, force)) squares += change.squaredNorm();
      const double slope = std::sqrt(squares / static_cast<double>(bins_.rows()));
      const double wanted = slope > 0.0 ? kWantedChange * residual / slope : 100.0 * force;
      const bool near = wanted < 3.0 * force && wanted > force / 3.0;
      force = std::clamp(wanted, 1e-9, 1e6);
      if (near) break;
    }
    return force;
  }

 private:
  std::vector<Interval> intervals(std::size_t trial, int number) const {
    std::vector<Interval> found;
    const Eigen::VectorXd& times = problem_.predictor().trials()[trial].measured.times;
    for (const Segment& segment : problem_.segments()) {
      if (segment.stretch.trial != trial) continue;
      const double begin = times(segment.first_counted()) + number * width_;
      const double end = std::min(begin + width_, times(segment.stretch.last - 1));
      if (begin < end - 1e-9) found.emplace_back(begin, end);
    }
    return found;
  }

  /// By segment; empty where it cannot be simulated.
  std::vector<Eigen::MatrixXd> predictions(const TrialPredictor& predictor) const {
    std::vector<Eigen::MatrixXd> all;
    Prediction prediction;
    for (std::size_t k = 0; k < problem_.segments().size(); ++k) {
      const Segment& segment = problem_.segments()[k];
      StartState start = segment.start;
      for (std::size_t j = 0; j < segment.unknown.size(); ++j)
        set_component(start, segment.unknown[j], point_.states[k](static_cast<Eigen::Index>(j)));
      predictor.predict(segment.stretch, values_, start, 0, prediction);
      all.emplace_back();
      if (!prediction.valid) continue;
      Eigen::MatrixXd rows(static_cast<Eigen::Index>(segment.rows.size()), 1);
      for (std::size_t i = 0; i < segment.rows.size(); ++i)
        rows(static_cast<Eigen::Index>(i), 0) =
            prediction.samples(segment.rows[i], segment.columns[i]) /
            problem_.scales()[problem_.place(k, static_cast<Eigen::Index>(i)).channel];
      all.back() = bins_.means(k, rows);
    }
    return all;
  }

  const ShootingProblem& problem_;
  const RowBins& bins_;
  const FitPoint& point_;
  const std::vector<double>& values_;
  DisturbedJoint joint_;
  double width_;
  std::unique_ptr<CompiledModel> model_;
  std::vector<Eigen::MatrixXd> calm_;
};

bool floats(const RobotSpec& robot) {
  return std::any_of(robot.bodies.begin(), robot.bodies.end(), [&](const BodySpec& body) {
    return std::none_of(robot.joints.begin(), robot.joints.end(),
                        [&](const JointSpec& joint) { return joint.child == body.name; });
  });
}

}  // namespace

ForceResponses force_responses(const ModelDefinition& definition, const ShootingProblem& problem, const RowBins& bins,
                               const FitPoint& point, const std::vector<double>& values, double residual, int threads) {
  ForceResponses responses;
  const RobotSpec& robot = definition.structure.robot;
  std::vector<DisturbedJoint> joints;
  for (const JointSpec& joint : robot.joints)
    if (joint.kind == JointKind::hinge || joint.kind == JointKind::slider) {
      joints.push_back({joint.name, "force_pulse_" + joint.name, 1.0});
      responses.units.emplace_back(joint.kind == JointKind::hinge ? "N*m" : "N");
    }
  if (joints.empty() || joints.size() > kMostDisturbed || floats(robot)) return {};
  double longest = 0.0;
  for (const Segment& segment : problem.segments())
    longest = std::max(longest, duration_of(segment, problem.predictor().trials()));
  responses.width = std::max(kShortestPulse, longest / kMostPulses);
  const int pulses = std::max(1, static_cast<int>(std::ceil(longest / responses.width - 1e-6)));
  for (std::size_t k = 0; k < problem.segments().size(); ++k) {
    const Segment& segment = problem.segments()[k];
    const double begin = problem.predictor().trials()[segment.stretch.trial].measured.times(segment.first_counted());
    responses.times.emplace_back(
        Eigen::VectorXd::LinSpaced(pulses, begin + 0.5 * responses.width, begin + (pulses - 0.5) * responses.width));
    responses.of.emplace_back();
  }
  for (const DisturbedJoint& joint : joints) {
    responses.joints.push_back(joint.joint);
    Pulser pulser(definition, problem, bins, point, values, joint, responses.width);
    const double force = pulser.size(residual);
    for (std::size_t k = 0; k < problem.segments().size(); ++k)
      responses.of[k].emplace_back(Eigen::MatrixXd::Zero(bins.rows(k), pulses));
    parallel_for(static_cast<std::size_t>(pulses), threads, [&](std::size_t pulse, int) {
      const std::vector<Eigen::VectorXd> change = pulser.response(static_cast<int>(pulse), force);
      for (std::size_t k = 0; k < change.size(); ++k)
        responses.of[k].back().col(static_cast<Eigen::Index>(pulse)) = change[k];
    });
  }
  return responses;
}

}  // namespace lacuna
