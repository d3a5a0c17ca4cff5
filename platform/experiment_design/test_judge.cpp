#include "experiment_design/test_judge.h"

#include "experiment_design/test_line.h"
#include "evaluation/prediction/target_simulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lacuna {
namespace {

constexpr const char* kEncoding = "command_series";
constexpr const char* kFitness = "model_disagreement";
constexpr double kMostTrials = 1e6;
constexpr int kMostSteps = 6;  ///< of a refit
constexpr double kTrustedEnough = 0.95;
constexpr double kFastest = 5.0;  ///< Hz, as far as the control period allows

/// A component with its defaults, by name.
template <class Interface>
Chosen<Interface> component(const PluginCatalog& catalog, const std::string& name) {
  Chosen<Interface> chosen;
  chosen.origin = catalog.origin<Interface>(name);
  chosen.component = &catalog.get<Interface>(name);
  for (const ParameterDeclaration& declaration : chosen->parameters())
    chosen.parameters.push_back(declaration.default_value);
  return chosen;
}

/// Sets a parameter by its name.
template <class Interface>
void set(Chosen<Interface>& chosen, const std::string& name, double value) {
  const ParameterDeclarations declarations = chosen->parameters();
  for (std::size_t i = 0; i < declarations.size(); ++i)
    if (declarations[i].name == name) chosen.parameters[i] = value;
}

/// The channels that are read and the deviation of a reading: correlated readings count as one.
struct Readings {
  std::vector<Eigen::Index> channels;
  std::vector<double> deviations;
};

Readings readings_of(const NextTestTask& task) {
  Readings readings;
  const double together = std::max(1.0, 2.0 * task.correlation_time / task.space.control_period);
  const std::vector<Channel>& channels = task.candidates.front().model.channels();
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (const ChannelNoise& noise : task.noise)
      if (noise.channel == channels[c].name) {
        readings.channels.push_back(static_cast<Eigen::Index>(c));
        readings.deviations.push_back(noise.deviation * std::sqrt(together));
      }
  return readings;
}

const NextTestTask& checked(const NextTestTask& task) {
  if (task.candidates.size() < 2) throw Error("telling candidates apart needs two candidates; only one is given");
  if (task.candidates[0].model.channels() != task.candidates[1].model.channels())
    throw Error(task.candidates[0].name + " and " + task.candidates[1].name +
                " have different sensors, so no test can tell them apart");
  for (const TestCandidate& candidate : task.candidates) {
    const Eigen::Index fitted = candidate.coordinates();
    if (candidate.covariance.rows() != fitted || candidate.covariance.cols() != fitted)
      throw Error(fmt::format("the covariance of {} is {} × {}, but {} of its values are fitted{}", candidate.name,
                              candidate.covariance.rows(), candidate.covariance.cols(), fitted,
                              candidate.command_interval > 0.0 ? ", including the timestamp offset" : ""));
  }
  if (readings_of(task).channels.empty())
    throw Error(
        "the noise of no sensor is known, so the worth of a test cannot be computed; state noise or record more");
  return task;
}

CandidatePredictor predictor(const NextTestTask& task, std::size_t which) {
  Readings readings = readings_of(task);
  EngineSettings engine = task.candidates.front().definition.engine;
  engine.control_period = task.space.control_period;
  return {task.candidates[which],       sample_times(engine, task.space.duration),
          std::move(readings.channels), std::move(readings.deviations),
          task.start_deviation,         task.work};
}

/// Refits the other candidate to the truth by Gauss-Newton steps with the derivatives at its fit, until the first-order
/// prediction of a step agrees with the simulated one to a small share of the remaining difference. Returns the share
/// of the difference that remains beyond this error: 0 where another step might explain everything.
double refit(const CandidatePrediction& truth, const CandidatePredictor& predictor, const Test& test, int worker,
             CandidatePrediction& candidate) {
  if (candidate.follows.cols() == 0) return 1.0;
  double trusted = 0.0;
  candidate.moved = Eigen::VectorXd::Zero(candidate.follows.cols());
  for (int step = 0; step < kMostSteps && trusted < kTrustedEnough; ++step) {
    const Eigen::VectorXd left = unexplained(truth, candidate);
    const Eigen::VectorXd moved = left.tail(candidate.moved.size());
    Eigen::VectorXd readings;
    if (!predictor.predict_moved(test, worker, moved, readings)) return 0.0;
    const double error = (readings - candidate.readings - candidate.follows * (moved - candidate.moved)).norm();
    trusted = error > 0.0 ? std::max(0.0, 1.0 - error / left.norm()) : 1.0;
    candidate.readings = std::move(readings);
    candidate.moved = moved;
  }
  return trusted;
}

}  // namespace

TestJudge::TestJudge(const NextTestTask& task)
    : task_(checked(task)),
      encoding_(component<TestEncoding>(task.catalog, kEncoding)),
      fitness_(component<TestFitness>(task.catalog, kFitness)),
      candidates_{predictor(task, 0), predictor(task, 1)} {
  set(fitness_, "noise", 1.0);  // it is in standard deviations
  const double lowest = std::max(1.0 / task.space.duration, 1e-3);
  set(encoding_, "lowest_frequency", lowest);
  set(encoding_, "highest_frequency", std::max(lowest, std::min(kFastest, 0.25 / task.space.control_period)));
  layout_ =
      guarded_call(encoding_.origin, "layout", [&] { return encoding_->layout(task.space, encoding_.parameters); });
}

Genome TestJudge::random(RandomStream& random) const {
  return sayable(task_.space,
                 guarded_call(encoding_.origin, "random", [&] { return encoding_->random(layout_, random); }));
}

std::optional<TestJudge::Judgement> TestJudge::judgement(const Genome& genome, const std::string& setup,
                                                         int worker) const {
  Test test = guarded_call(encoding_.origin, "decode",
                           [&] { return encoding_->decode(task_.space, encoding_.parameters, genome); });
  test.start = task_.start;
  test.setup = setup;
  Judgement judgement;
  std::array<CandidatePrediction, 2>& truths = judgement.truths;
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    if (!candidates_[i].predict(test, worker, truths[i])) return std::nullopt;
  judgement.refitted = truths;
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    judgement.trusted[i] = refit(truths[1 - i], candidates_[i], test, worker, judgement.refitted[i]);
  return judgement;
}

double TestJudge::nats(const Genome& genome, int worker, const std::string& setup) const {
  const auto judged = judgement(genome, setup, worker);
  return judged ? worse(*judged, 1.0) : -1.0;
}

double TestJudge::worse(const Judgement& judgement, double trials) const {
  const auto direction = [&](std::size_t truth) {
    const std::size_t candidate = 1 - truth;
    return score(judgement.trusted[candidate] *
                 unexplained(judgement.truths[truth], judgement.refitted[candidate], trials));
  };
  return std::min(direction(0), direction(1));
}

/// By the test fitness: the difference that remains after a refit, compared with none.
double TestJudge::score(const Eigen::VectorXd& left) const {
  std::array<TestPrediction, 2> sides;
  for (TestPrediction& side : sides) {
    side.sensors.channels = {{"deviations", "1"}};
    side.sensors.times = Eigen::VectorXd::LinSpaced(left.size(), 0.0, static_cast<double>(left.size() - 1));
    side.sensors.samples = TimeSeries::Samples::Zero(left.size(), 1);
  }
  sides[0].sensors.samples.col(0) = left;
  return guarded_call(fitness_.origin, "score", [&] { return fitness_->score({}, sides, fitness_.parameters); });
}

double TestJudge::trials_needed(const Genome& genome, const std::string& setup) const {
  const auto judged = judgement(genome, setup, 0);
  if (!judged || worse(*judged, kMostTrials) < kDecisiveNats) return std::numeric_limits<double>::infinity();
  double too_few = 0.0, enough = kMostTrials;
  while (enough - too_few > 1.0) {
    const double between = std::floor(0.5 * (too_few + enough));
    (worse(*judged, between) >= kDecisiveNats ? enough : too_few) = between;
  }
  return enough;
}

}  // namespace lacuna
