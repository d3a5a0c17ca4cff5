#include "experiment_design/next_test.h"

#include "experiment_design/candidate_pendulum.h"
#include "experiment_design/candidate_predictor.h"
#include "experiment_design/test_judge.h"
#include "experiment_design/test_line.h"
#include "fitting/shooting/parameter_space.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

NextTestTask task_of(const Pendulum& pendulum, std::vector<TestCandidate> candidates) {
  return {.catalog = built_catalog(),
          .candidates = std::move(candidates),
          .noise = {{"angle", "rad", kReadingNoise, "declared"}},
          .space = test_space(pendulum.definition.structure.robot, pendulum.definition.engine, 4.0),
          .start = {},
          .start_deviation = {}};
}

const char* const kCoulomb = R"({ effect = "coulomb_friction", where = "joint.hinge", start = { torque = 0.03 } })";
const char* const kStribeck =
    R"({ effect = "stribeck_friction", where = "joint.hinge", start = { coulomb = 0.025, excess = 0.02, velocity = 0.1 } })";

/// What a test of four seconds can say of mass, damping and friction when it is all there is.
std::vector<double> loose(const Pendulum& pendulum, double share = 0.05) {
  std::vector<double> deviations;
  for (const double value : pendulum.values) deviations.push_back(share * std::abs(value));
  return deviations;
}

TEST(NextTest, BeatsTheMedianRandomTestAndStaysWithinTheLimits) {
  const Pendulum coulomb(kCoulomb), stribeck(kStribeck);
  NextTestTask task =
      task_of(coulomb, {coulomb.candidate("coulomb", loose(coulomb)), stribeck.candidate("stribeck", loose(stribeck))});
  const NextTest test = next_test(task);
  EXPECT_GT(test.random_nats, 0.0);
  EXPECT_GT(test.nats, 2.0 * test.random_nats) << to_string(test);
  EXPECT_LE(test.trials, test.random_trials);
  EXPECT_EQ(test.evaluations, task.evaluations);
  EXPECT_THAT(to_string(test), testing::StartsWith(test.line + ": "));
  const TestLine read = parse_test_line(task.space, test.line);  // throws beyond the limits
  EXPECT_EQ(read.duration, task.space.duration);
  task.work.threads = 2;
  const NextTest again = next_test(task);
  EXPECT_EQ(again.line, test.line);
  EXPECT_EQ(again.nats, test.nats);
}

/// Candidates that keep their values differ most where other values would explain the difference.
TEST(NextTest, ChosenWithoutRefitsIsWorthLessOnceCandidatesAreRefitted) {
  const Pendulum coulomb(kCoulomb), stribeck(kStribeck);
  const auto task_with = [&](double share) {
    NextTestTask task = task_of(coulomb, {coulomb.candidate("coulomb", loose(coulomb, share)),
                                          stribeck.candidate("stribeck", loose(stribeck, share))});
    task.evaluations = 30;
    return task;
  };
  const NextTestTask refitted = task_with(0.05), kept = task_with(1e-9);
  const NextTest best = next_test(refitted), naive = next_test(kept);
  const TestJudge judge(refitted);
  const double worth = judge.nats(parse_test_line(refitted.space, naive.line).genome, 0);
  EXPECT_GT(best.nats, 1.5 * worth) << naive.line;
}

/// Two models of one structure, one deviation of their only uncertain value apart, on a test that shows the value well:
/// a refit explains everything at the price of that one deviation, ½ nat.
TEST(NextTest, OfOneStructureTellsNoMoreThanWhatTheFitLeftOpen) {
  const Pendulum one(""), other("");
  constexpr double kDeviation = 0.002;  // kg
  Pendulum heavier("");
  heavier.values[0] += kDeviation;
  NextTestTask task =
      task_of(one, {one.candidate("one", {kDeviation, 1e-9}), heavier.candidate("heavier", {kDeviation, 1e-9})});
  task.evaluations = 20;
  const NextTest refitted = next_test(task);
  EXPECT_NEAR(refitted.nats, 0.5, 0.02);
  EXPECT_TRUE(std::isinf(refitted.trials)) << "no number of trials tells one structure from itself";
  NextTestTask known = task_of(one, {one.candidate("one", {1e-9, 1e-9}), heavier.candidate("heavier", {1e-9, 1e-9})});
  known.evaluations = task.evaluations;
  EXPECT_GT(next_test(known).nats, 10.0) << "known values differ and cannot be refitted";
}

const char* const kSpring =
    R"({ effect = "joint_spring", where = "joint.hinge", start = { stiffness = 0.02 }, fixed = ["rest"] })";
const char* const kCubic =
    R"({ effect = "cubic_stiffness", where = "joint.hinge", start = { stiffness = 0.03 }, fixed = ["rest"] })";

/// What a model reads in a test, and a scan of one of its values for the least that is left of a difference.
struct Scan {
  Scan(const NextTestTask& task, const std::string& line) {
    const TestLine read = parse_test_line(task.space, line);
    const TestEncoding& encoding = built_catalog().get<TestEncoding>("command_series");
    std::vector<double> parameters;
    for (const ParameterDeclaration& declaration : encoding.parameters())
      parameters.push_back(declaration.default_value);
    test = encoding.decode(task.space, parameters, read.genome);
    for (int i = 0; i * task.space.control_period <= task.space.duration + 1e-9; ++i)
      times.push_back(i * task.space.control_period);
  }
  Eigen::VectorXd readings(const Pendulum& pendulum, const std::vector<double>& values) const {
    const TestPredictor predictor(*pendulum.model, times, {1});
    TestPrediction prediction;
    std::uint64_t steps = 0;
    std::string reason;
    EXPECT_TRUE(predictor.predict({{values.begin(), values.end()}}, test, 0, prediction, steps, reason)) << reason;
    return prediction.sensors.samples.col(0) / kReadingNoise;
  }
  /// Nats when only `free` of the candidate's values can move, with that deviation: by golden section.
  double nats(const Pendulum& truth, const Pendulum& candidate, std::size_t free, double deviation) const {
    const Eigen::VectorXd wanted = readings(truth, truth.values);
    const auto cost = [&](double moved) {
      std::vector<double> values = candidate.values;
      values[free] += moved * deviation;
      return 0.5 * ((wanted - readings(candidate, values)).squaredNorm() + moved * moved);
    };
    constexpr double kGolden = 0.6180339887498949;
    double low = -4.0, high = 4.0;
    for (int i = 0; i < 40; ++i) {
      const double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
      (cost(left) < cost(right) ? high : low) = cost(left) < cost(right) ? right : left;
    }
    return cost(0.5 * (low + high));
  }
  lacuna::Test test;
  std::vector<double> times;
};

TEST(NextTest, IsWorthWhatAScanOfTheCandidatesValueLeaves) {
  const Pendulum spring(kSpring), cubic(kCubic);
  const std::size_t own = 2;  // the effect's, after mass and damping
  constexpr double kDeviation = 0.01, kHeld = 1e-9;
  constexpr double kTolerance = 0.06;  // the refit keeps the derivatives of where it began
  NextTestTask task = task_of(spring, {spring.candidate("spring", {kHeld, kHeld, kDeviation}),
                                       cubic.candidate("cubic", {kHeld, kHeld, kDeviation})});
  task.evaluations = 20;
  const NextTest test = next_test(task);
  const Scan scan(task, test.line);
  const double scanned = std::min(scan.nats(spring, cubic, own, kDeviation), scan.nats(cubic, spring, own, kDeviation));
  EXPECT_NEAR(test.nats, scanned, kTolerance * scanned) << to_string(test);
}

/// The readings follow a value as a difference of simulations one way and the other says.
TEST(CandidatePredictorTest, FollowsItsValuesAndItsStart) {
  const Pendulum pendulum("");
  const TestCandidate candidate = pendulum.candidate("rigid", {1e-4, 1e-9});
  const std::vector<double> times = {0.0, 0.5, 1.0, 1.5};
  const CandidatePredictor predictor(candidate, times, {0}, {kReadingNoise}, {1e-4, 0.0}, {1});
  lacuna::Test test;
  test.duration = 1.5;
  CommandSeries commands;
  commands.series = {{{"motor", "N*m"}}, Eigen::VectorXd::Zero(1), TimeSeries::Samples::Constant(1, 1, 0.3)};
  test.drive = commands;
  CandidatePrediction prediction;
  ASSERT_TRUE(predictor.predict(test, 0, prediction));
  ASSERT_EQ(prediction.follows.cols(), 3) << "mass, damping, and where it starts; not how fast";
  const auto read = [&](double mass, double start) {
    const TestPredictor plain(*pendulum.model, times, {1});
    TestPrediction seen;
    std::uint64_t steps = 0;
    std::string reason;
    lacuna::Test moved = test;
    moved.start = {{start}, {0.0}};
    EXPECT_TRUE(plain.predict({{mass, pendulum.values[1]}}, moved, 0, seen, steps, reason)) << reason;
    return Eigen::VectorXd(seen.sensors.samples.col(0) / kReadingNoise);
  };
  const double mass = pendulum.values[0];
  const Eigen::VectorXd by_mass = 0.5 * (read(mass + 1e-4, 0.0) - read(mass - 1e-4, 0.0));
  const Eigen::VectorXd by_start = 0.5 * (read(mass, 1e-4) - read(mass, -1e-4));
  const Eigen::Index of_mass = prediction.follows.col(0).norm() > prediction.follows.col(1).norm() ? 0 : 1;
  EXPECT_LT((prediction.follows.col(of_mass).cwiseAbs() - by_mass.cwiseAbs()).norm(), 0.01 * by_mass.norm());
  EXPECT_LT((prediction.follows.col(2) - by_start).norm(), 0.01 * by_start.norm());
}

/// Where it is not known within a sample interval when commands act, the readings follow that, too.
TEST(CandidatePredictorTest, FollowsTheInstantThatCommandsActAt) {
  constexpr double kInterval = 0.01, kDeviation = 0.4, kShift = 0.1;
  const Pendulum pendulum("");
  TestCandidate candidate = pendulum.candidate("rigid", {0.0, 0.0, kDeviation});
  candidate.command_interval = kInterval;
  candidate.command_shift = kShift;
  for (const Eigen::Index held : {0, 1}) candidate.covariance(held, held) = 1e-20;
  const std::vector<double> times = {0.5, 1.0, 1.5};
  const CandidatePredictor predictor(candidate, times, {0}, {kReadingNoise}, {}, {1});
  lacuna::Test test;
  test.duration = 1.5;
  CommandSeries commands;
  commands.series = {{{"motor", "N*m"}}, Eigen::Vector2d(0.0, 0.3), Eigen::Vector2d(0.1, 0.3)};
  test.drive = commands;
  CandidatePrediction prediction;
  ASSERT_TRUE(predictor.predict(test, 0, prediction));
  const auto read = [&](double delay) {
    const TestPredictor plain(*pendulum.model, times, {1});
    TestPrediction seen;
    std::uint64_t steps = 0;
    std::string reason;
    lacuna::Test moved = test;
    std::get<CommandSeries>(moved.drive).series.times.array() += delay;
    EXPECT_TRUE(plain.predict({pendulum.values}, moved, 0, seen, steps, reason)) << reason;
    return Eigen::VectorXd(seen.sensors.samples.col(0) / kReadingNoise);
  };
  EXPECT_LT((prediction.readings - read(kShift * kInterval)).norm(), 1e-6 * prediction.readings.norm());
  const double later = kShift + 0.5 * kDeviation;
  const Eigen::VectorXd by_delay = 2.0 * (read(later * kInterval) - read(kShift * kInterval));
  Eigen::Index widest = 0;
  prediction.follows.colwise().norm().maxCoeff(&widest);
  ASSERT_GT(by_delay.norm(), 1.0);
  EXPECT_LT((prediction.follows.col(widest).cwiseAbs() - by_delay.cwiseAbs()).norm(), 0.02 * by_delay.norm());
}

/// The candidates differ in nothing but the weight that nobody weighed, so that only tests with it tell them apart.
TEST(NextTest, AsksForTheSetupThatTellsTheCandidatesApart) {
  const PendulumWithLoads one(0.5), other(0.7);
  NextTestTask task = one.against(other);
  ASSERT_EQ(task.setups.size(), 2U);
  const NextTest test = next_test(task);
  ASSERT_TRUE(test.setup);
  EXPECT_EQ(test.setup->name(), "steps");
  EXPECT_EQ(test.evaluations, task.evaluations);
  EXPECT_GT(test.nats, 10.0);
  EXPECT_THAT(to_string(test), testing::HasSubstr(" s with setup steps (body.arm.mass fitted to this setup only): "));
  const TestJudge judge(task);
  const Genome genome = parse_test_line(task.space, test.line).genome;
  EXPECT_NEAR(judge.nats(genome, 0, "sine"), 0.0, 1e-9) << "both know that weight";
  EXPECT_EQ(judge.nats(genome, 0, "steps"), test.nats);
  task.work.threads = 2;
  const NextTest again = next_test(task);
  EXPECT_EQ(again.line, test.line);
  EXPECT_EQ(again.setup, test.setup);
}

/// One setup makes no other draws than none.
TEST(NextTest, DrawsTheSameTestsForOneSetup) {
  const PendulumWithLoads one(0.5), other(0.7);
  NextTestTask heavy = one.against(other);
  heavy.setups = {heavy.setups[1]};
  const Pendulum plain(""), heavier("");
  NextTestTask none = task_of(plain, {plain.candidate("one", {1e-9, 1e-9}), heavier.candidate("other", {1e-9, 1e-9})});
  none.candidates[0].values[0] = 0.5;
  none.candidates[1].values[0] = 0.7;
  none.evaluations = heavy.evaluations;
  const NextTest in_setup = next_test(heavy), without = next_test(none);
  EXPECT_EQ(in_setup.line, without.line);
  EXPECT_NEAR(in_setup.nats, without.nats, 1e-6 * without.nats);
  EXPECT_FALSE(without.setup);
}

TEST(NextTest, DoesNotCountWhatIsMoreThanEnough) {
  const NextTest test{"triangle motor 0.3 N*m 0.1 Hz 20 s", {}, {"a", "b"}, 2.3e9, 12.0, 1.0, 1.0};
  EXPECT_EQ(
      to_string(test),
      "triangle motor 0.3 N*m 0.1 Hz 20 s: more than 1000 nats of evidence per trial (a random test: 12), 1 trial for "
      "odds of 150 to 1, 5 nats (a random test: 1 trial)");
}

TEST(NextTest, SaysWhatItCannotTellApart) {
  const Pendulum one("");
  NextTestTask task = task_of(one, {one.candidate("one", {0.1, 0.01})});
  EXPECT_THROW(next_test(task), Error);
  task.candidates.push_back(one.candidate("two", {0.1}));
  EXPECT_THAT([&] { next_test(task); }, testing::ThrowsMessage<Error>(testing::HasSubstr("1 × 1")));
  task.candidates.pop_back();
  task.candidates.push_back(one.candidate("two", {0.1, 0.01}));
  task.space.upper[0] = kInfinity;
  EXPECT_THAT([&] { next_test(task); }, testing::ThrowsMessage<Error>(testing::HasSubstr("motor")));
  limit_to_trials(task.space, {});
  EXPECT_TRUE(std::isinf(task.space.upper[0]));
  Trial trial;
  trial.commands.series = {{{"motor", "N*m"}}, Eigen::VectorXd::LinSpaced(3, 0.0, 1.0), TimeSeries::Samples(3, 1)};
  trial.commands.series.samples << 0.1, 0.4, -0.2;
  limit_to_trials(task.space, {trial});
  EXPECT_EQ(task.space.upper[0], 0.4) << "the largest command so far";
  EXPECT_EQ(task.space.lower[0], -kTorqueLimit) << "a declared limit stays";
}

}  // namespace
}  // namespace lacuna
