#include "fitting/comparison.h"
#include "fitting/recorded_spring.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;

/// What the estimated starts of many recordings of one motion, each with noise of its own, do to the prediction (RMS
/// over recordings and scored time), and what `compare` says they do.
struct StartShare {
  double found = 0.0;
  double stated = 0.0;
};

StartShare share_of_starts(const OneJointModel& model, const std::vector<Trial>& recordings, const Trial& exact) {
  const ModelDefinition definition = spring_definition();
  const NoiseSection noise;
  double found = 0.0, stated = 0.0;
  for (const Trial& recording : recordings) {
    const std::vector<Trial> one = {recording};
    const TrialComparison trial = compare({definition, model, one, noise, {0.5}, nullptr, {}, 1, {2}}).trials[0];
    const Eigen::Index scored = trial.predicted.rows() - trial.first_scored;
    found += (trial.predicted - exact.measured.samples).bottomRows(scored).squaredNorm() / static_cast<double>(scored);
    stated += trial.channels[0].from_start * trial.channels[0].from_start;
  }
  const auto count = static_cast<double>(recordings.size());
  return {std::sqrt(found / count), std::sqrt(stated / count)};
}

TEST(Compare, TheShareOfTheStartIsWhatNoisyHeadsDoToAPrediction) {
  std::vector<Trial> recordings;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) recordings.push_back(spring_trial(kNoise, seed, 2.0, 1000.0));
  const StartShare share = share_of_starts(OneJointModel(spring), recordings, spring_trial(0.0, 1, 2.0, 1000.0));
  EXPECT_GT(share.found, 2.0 * kNoise);
  EXPECT_NEAR(share.stated, share.found, 0.15 * share.found);  // 150 draws of about one number: ±6 %
}

/// The spring with dry friction of 0.8 rad/s², at rest within its reach of ±0.2 rad.
double stuck_spring(std::span<const double> values, double q, double v, double u) {
  return spring(values, q, v, u) - 0.8 * std::tanh(v / 1e-3);
}

TEST(Compare, AStartThatIsStuckWithinOneEncoderStepMovesNoMoreThanThatStep) {
  const double step = 3e-3;
  const OneJointModel model(stuck_spring);
  CommandSeries commands = two_sines(2.0, 1.5);
  commands.series.samples.topRows(30).setZero();  // 0.3 s of rest
  const auto recorded_from = [&](double position) {
    return record(model, {0.5}, regular_times(401, 200.0), commands, {{position}, {0.0}}, 0.0, 1);
  };
  const Trial exact = recorded_from(0.0);
  std::vector<Trial> recordings;
  double squares = 0.0;  // of what it does to stand anywhere in the encoder's step
  for (int k = -10; k <= 10; ++k) {
    Trial recording = recorded_from(0.045 * k * step);
    squares += (recording.measured.samples - exact.measured.samples).bottomRows(390).squaredNorm() / 390.0;
    recording.measured.samples = (recording.measured.samples / step).array().round().matrix() * step;
    recording.sensor_noise = {step / std::sqrt(12.0)};
    recordings.push_back(std::move(recording));
  }
  const double possible = std::sqrt(squares / 21.0);
  EXPECT_LT(possible, step / std::sqrt(12.0));
  EXPECT_NEAR(share_of_starts(model, recordings, exact).stated, possible, 0.5 * possible);
}

}  // namespace
}  // namespace lacuna
