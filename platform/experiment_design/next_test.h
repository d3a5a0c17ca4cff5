#pragma once

#include <lacuna/test_encoding.h>

#include "evaluation/model/known_setups.h"
#include "evaluation/model/model_definition.h"
#include "fitting/floor/noise_floor.h"
#include "foundation/work.h"
#include "loading/plugin_catalog.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A candidate model, with its uncertainty given the data so far. Everything that it refers to must live until
/// `next_test` returns.
struct TestCandidate {
  std::string name;  ///< as users see it: "coulomb_friction @ joint.hinge"
  const ModelDefinition& definition;
  const CompiledModel& model;  ///< of `definition`
  std::vector<double> values;  ///< of its free values, SI
  /// Of the free values' coordinates (fitting/shooting/parameter_space.h), as `Refit::covariance`: a row and a column a
  /// value. A value whose row is 0 or NaN is held where it stands at a bound, and is known no better than its bounds
  /// say where it does not. With a `command_interval` one more row and column: that of the instant that commands act
  /// at.
  Eigen::MatrixXd covariance;
  /// s, the range either way within which the timestamp offset of the commands is fitted beside the values (timing.h);
  /// the offset counts in multiples of it. 0: the offset is known.
  double command_interval = 0.0;
  double command_shift = 0.0;  ///< how much later than recorded commands act, as fitted; in multiples of the interval

  Eigen::Index coordinates() const {
    return static_cast<Eigen::Index>(definition.free.size()) + (command_interval > 0.0 ? 1 : 0);
  }
};

/// The task of the test design.
struct NextTestTask {
  const PluginCatalog& catalog;           ///< with the plugins `command_series` and `model_disagreement`
  std::vector<TestCandidate> candidates;  ///< the first two are to be told apart; both have the robot's sensors
  std::vector<ChannelNoise> noise;  ///< standard deviations of single readings, by channel; other channels are not read
  TestSpace space;  ///< limits (evaluation/prediction/test_space.h), control period, and the duration of the test
  double correlation_time = 0.0;  ///< s, of the noise: readings closer than this count as less than one each
  StartState start;               ///< where the test starts
  /// How well that is known: deviations of the joint coordinates, positions and then velocities; what is above 0 is
  /// refitted together with the values. Empty: exactly.
  std::vector<double> start_deviation;
  /// Setups of the rig for the test; both models have them.
  std::vector<KnownSetup> setups = std::vector<KnownSetup>(1);
  int evaluations = 60;  ///< budget; one evaluation predicts a test with both models and all their refitted quantities
  std::uint64_t seed = 1;
  Work work = {};
};

inline constexpr double kDecisiveNats = 5.0;  ///< odds of 150 to 1

/// A proposal, beside what chance does.
struct NextTest {
  std::string line;                       ///< as `lacuna trial --test` takes it (experiment_design/test_line.h)
  std::optional<KnownSetup> setup;        ///< setup to make it in; nothing where no recording has one
  std::array<std::string, 2> candidates;  ///< their names
  double nats = 0.0;                      ///< expected evidence of one trial between the two candidates
  double random_nats = 0.0;               ///< the same for the median random test
  double trials = 0.0;                    ///< until `kDecisiveNats`; infinite: more than a million
  double random_trials = 0.0;             ///< the same for the median random test
  int evaluations = 0;
  int invalid = 0;  ///< evaluations of tests that one of the models cannot carry out
};

/// METHOD step 12: the test on which two candidates, each refitted to it, are expected to differ most, within the
/// actuators' limits. The worth of a test is the log likelihood in nats that it is expected to give the right
/// candidate, in the worse direction of the pair: the other candidate is refitted to the new trial and the data so far
/// by a few Gauss-Newton steps with its derivatives (candidate_refit.h). The error of this linearisation is subtracted
/// from the worth; otherwise tests with an unpredictable outcome would win. The refit is made here and not in the test
/// fitness, because it needs the models, the covariance of their values, bounds, and the uncertainty of the start,
/// which a `TestFitness` does not get. The fitness `model_disagreement` evaluates the difference that remains. Noise
/// counts as white beyond `correlation_time`.
///
/// Tests are those of the encoding `command_series`. Three fifths of the budget are random draws, of which the median
/// is reported; the rest refines the best four by small changes. Setups take turns in the random draws; then the best
/// commands are tried in every other setup, and small changes keep the setup. A test in a setup is predicted with the
/// values of the setup and each model's own values for it. The proposal does not depend on the number of threads.
/// Throws `Error` where there are fewer than two candidates, a covariance has another size, their sensors differ, an
/// actuator has no limits, or no test can be carried out; and `Interrupted`.
///
/// Literature: W. G. Hunter and A. M. Reiner, Technometrics 7 (1965) 307-323; A. C. Atkinson and V. V. Fedorov,
/// Biometrika 62 (1975) 57-70.
NextTest next_test(const NextTestTask& task);

/// "triangle motor 0.3 N*m 0.1 Hz 20 s: 12 nats of evidence per trial (a random test: 0.8), 1 trial for odds of 150 to
/// 1, 5 nats (a random test: 7 trials)", with " with setup heavy (body.load.mass = 0.49 kg)" before the colon where
/// there is one.
std::string to_string(const NextTest& test);

}  // namespace lacuna
