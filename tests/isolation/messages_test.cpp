#include "isolation/carried.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

/// What travels between two processes arrives as it was, bit by bit. A member more does not compile here until it is
/// compared.
namespace lacuna {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TimeSeries series_of(double value) {
  TimeSeries series;
  series.channels = {{"angle", "rad"}, {"rate", "rad/s"}};
  series.times = Eigen::Vector3d(0.0, 0.1, 0.2);
  series.samples = TimeSeries::Samples::Constant(3, 2, value);
  return series;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  if (a.empty()) return;
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

void expect_same(const TimeSeries& a, const TimeSeries& b) {
  const auto& [channels, times, samples] = a;
  EXPECT_EQ(channels, b.channels);
  EXPECT_EQ(times, b.times);
  ASSERT_EQ(samples.rows(), b.samples.rows());
  ASSERT_EQ(samples.cols(), b.samples.cols());
  EXPECT_EQ(std::memcmp(samples.data(), b.samples.data(), sizeof(double) * static_cast<std::size_t>(samples.size())),
            0);
}

void expect_same(const CommandSeries& a, const CommandSeries& b) {
  const auto& [series, hold, before, may_be_off] = a;
  expect_same(series, b.series);
  EXPECT_EQ(hold, b.hold);
  expect_same(before, b.before);
  EXPECT_EQ(may_be_off, b.may_be_off);
}

Trial trial() {
  Trial trial;
  trial.name = "3";
  trial.commands = {series_of(0.5), Hold::first_order, {0.25, kNan}, true};
  trial.measured = series_of(kNan);
  trial.initial = {{InitialKnowledge::given, 0.5, -0.25}};
  trial.sensor_noise = {0.01, kNan};
  trial.command_noise = {kNan};
  trial.held_out = true;
  trial.setup = {"heavy", {{"body.load.mass", 2.0}}};
  trial.closed_loop = true;
  trial.centre_of_mass = series_of(0.125);
  return trial;
}

void expect_same(const Trial& a, const Trial& b) {
  const auto& [name, commands, measured, initial, sensor_noise, command_noise, held_out, controller, setup, closed_loop,
               centre_of_mass] = a;
  EXPECT_EQ(name, b.name);
  expect_same(commands, b.commands);
  expect_same(measured, b.measured);
  ASSERT_EQ(initial.size(), b.initial.size());
  for (std::size_t i = 0; i < initial.size(); ++i) {
    const auto& [knowledge, position, velocity] = initial[i];
    EXPECT_EQ(knowledge, b.initial[i].knowledge);
    EXPECT_EQ(position, b.initial[i].position);
    EXPECT_EQ(velocity, b.initial[i].velocity);
  }
  expect_same(sensor_noise, b.sensor_noise);
  expect_same(command_noise, b.command_noise);
  EXPECT_EQ(held_out, b.held_out);
  EXPECT_EQ(controller, nullptr) << "it stays at home";
  EXPECT_EQ(setup, b.setup);
  EXPECT_EQ(closed_loop, b.closed_loop);
  expect_same(centre_of_mass, b.centre_of_mass);
}

TEST(Messages, AStateArrivesAsItWas) {
  EeaState state;
  state.pass = 4;
  TargetTrial& sent = state.trials.emplace_back();
  sent.drive = {CommandSeries{series_of(0.75), Hold::zero_order, {}, false}, 0.2, {{0.1}, {0.2}}, "heavy"};
  sent.trial = trial();
  sent.genome = {1.0, -2.0};
  sent.set_aside_in = 3;
  state.best.push_back({17, {0.5, kNan}, {{1.5, 2.5}}, 0.25, 1});
  const Request received = from_bytes<Request>(to_bytes(Request(BeginExploration{wired(state)})));
  ASSERT_TRUE(std::holds_alternative<BeginExploration>(received));
  const auto& [pass, trials, best] = std::get<BeginExploration>(received).state;
  EXPECT_EQ(pass, 4);
  ASSERT_EQ(trials.size(), 1U);
  const auto& [genome, commands, duration, start, setup, of_target, set_aside_in] = trials[0];
  expect_same(genome, sent.genome);
  ASSERT_TRUE(commands);
  expect_same(*commands, std::get<CommandSeries>(sent.drive.drive));
  EXPECT_EQ(duration, 0.2);
  expect_same(start.positions, {0.1});
  expect_same(start.velocities, {0.2});
  EXPECT_EQ(setup, "heavy");
  expect_same(of_target, sent.trial);
  EXPECT_EQ(set_aside_in, 3);
  ASSERT_EQ(best.size(), 1U);
  const auto& [number, of_model, values, score, restart] = best[0];
  EXPECT_EQ(number, 17U);
  expect_same(of_model, {0.5, kNan});
  expect_same(values, {1.5, 2.5});
  EXPECT_EQ(score, 0.25);
  EXPECT_EQ(restart, 1);
}

TEST(Messages, ATaskArrivesAsItWas) {
  const WorkerTask sent{"rig.toml", "[robot]\n", {"a=1"}, {"b=2"}, {"/opt/plugins"}, 2.5, 1'000'000, {"abc"}};
  const Request received = from_bytes<Request>(to_bytes(Request(sent)));
  const auto& [experiment, text, overrides, decided, plugin_paths, evaluation_limit, memory, files] =
      std::get<WorkerTask>(received);
  EXPECT_EQ(experiment, sent.experiment);
  EXPECT_EQ(text, sent.text);
  EXPECT_EQ(overrides, sent.overrides);
  EXPECT_EQ(decided, sent.decided);
  EXPECT_EQ(plugin_paths, sent.plugin_paths);
  EXPECT_EQ(evaluation_limit, sent.evaluation_limit);
  EXPECT_EQ(memory, sent.memory);
  EXPECT_EQ(files, sent.files);
}

TEST(Messages, ScoresAndJudgementsArriveAsTheyWere) {
  const std::vector<ModelScore> sent = {{.total = 1.0 / 3.0,
                                         .trials = {0.1, kNan},
                                         .kind = ScoreKind::abandoned,
                                         .reason = "why",
                                         .steps = 7,
                                         .values = {2.0}}};
  const auto scores = from_bytes<std::vector<ModelScore>>(to_bytes(sent));
  ASSERT_EQ(scores.size(), 1U);
  const auto& [total, trials, kind, reason, steps, values] = scores[0];
  EXPECT_EQ(total, 1.0 / 3.0);
  expect_same(trials, sent[0].trials);
  EXPECT_EQ(kind, ScoreKind::abandoned);
  EXPECT_EQ(reason, "why");
  EXPECT_EQ(steps, 7U);
  expect_same(values, {2.0});
  const auto judged = from_bytes<std::vector<JudgedTest>>(to_bytes(std::vector<JudgedTest>{{0.5, "no", 9}}));
  const auto& [fitness, no, taken] = judged.at(0);
  EXPECT_EQ(fitness, 0.5);
  EXPECT_EQ(no, "no");
  EXPECT_EQ(taken, 9U);
  PredictedTrial predicted;
  predicted.valid = true;
  predicted.prediction = {series_of(0.5), series_of(0.25)};
  predicted.steps = 5;
  const auto [valid, prediction, of_it] = from_bytes<PredictedTrial>(to_bytes(predicted));
  EXPECT_TRUE(valid);
  expect_same(prediction.sensors, predicted.prediction.sensors);
  expect_same(prediction.centre_of_mass, predicted.prediction.centre_of_mass);
  EXPECT_EQ(of_it, 5U);
}

TEST(Messages, BytesThatAreNoneAreRefused) {
  const std::string bytes = to_bytes(Request(ScoreModelsRequest{{{1.0, 2.0}}, 0.5}));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(from_bytes<Request>(bytes.substr(0, size)), Error) << size;
  EXPECT_THROW(from_bytes<Request>("\xff"), Error);
  EXPECT_THROW(from_bytes<std::vector<double>>(std::string(8, '\xff')), Error) << "a size that cannot be";
}

TEST(Messages, SizesAndTruthValuesThatCannotBeAreRefused) {
  const std::string none = to_bytes(std::uint64_t{0});
  const struct {
    std::uint64_t rows, columns;
  } sizes[] = {{1ULL << 32U, 1ULL << 32U}, {1ULL << 63U, 1}, {1, 1ULL << 63U}, {0, 2}};
  for (const auto& [rows, columns] : sizes) {
    std::string series = none;  // without channels
    series.append(to_bytes(rows)).append(to_bytes(columns)).append(none).append(none);
    EXPECT_THROW(from_bytes<TimeSeries>(series), Error) << rows << " × " << columns;
  }
  EXPECT_THROW(from_bytes<bool>("\xff"), Error);
}

}  // namespace
}  // namespace lacuna
