#pragma once

#include "storage/eea/eea_store.h"
#include "storage/small_database.h"

#include <cstdint>
#include <mutex>
#include <random>

namespace lacuna::test {

/// A run of the algorithm with made-up numbers: what it appends for its n-th commit depends on n alone. A pass is a
/// commit with tests and the trial of the best of them, then one for each generation of models; the checkpoint is the
/// number of commits.
struct MadeUpRun {
  int passes = 2;
  int generations = 3;
  int models = 20;  ///< a generation
  int tests = 10;   ///< a pass
  int samples = 50;

  int commits() const { return passes * (1 + generations); }

  EeaRunRecord record() const {
    return {.replicate = 1,
            .metric = "mean_absolute_error",
            .fitness = "forward_distance",
            .fitness_unit = "m",
            .free = {{"body.torso.mass", "kg", 1.0, 7.0, 1.0}, {"sensor.knee.delay", "s", 0.0, 0.2, 0.0}},
            .truth = {2.5, kNotKnown},
            .model_genes = {"body.torso.mass", "sensor.knee.delay"},
            .test_genes = {"weight.1", "weight.2", "weight.3"},
            .passes = passes};
  }

  void commit(EeaStore& store, int number) const {
    append(store, number);
    store.commit({{static_cast<double>(number + 1)}});
  }

  void append(EeaStore& store, int number) const {
    std::mt19937_64 random(static_cast<std::uint64_t>(number));
    const int pass = 1 + number / (1 + generations);
    const int generation = number % (1 + generations) - 1;
    if (generation < 0) {
      for (int i = 0; i < tests; ++i) store.append(made_up_test(random, pass, i));
      store.append(target_trial(pass), made_up_trial(pass));
      return;
    }
    for (int i = 0; i < models; ++i) store.append(made_up_model(random, pass, generation, i));
    if (generation + 1 == generations) end_pass(store, pass);
  }

  std::uint64_t model_number(int pass, int generation, int index) const {
    const int number = ((pass - 1) * generations + generation) * models + index;
    return static_cast<std::uint64_t>(number);
  }
  std::uint64_t test_number(int pass, int index) const {
    const int number = (pass - 1) * tests + index;
    return static_cast<std::uint64_t>(number);
  }
  TimeSeries readings(double amplitude) const { return sine(samples, amplitude); }

  ModelRow made_up_model(std::mt19937_64& random, int pass, int generation, int index) const {
    ModelRow model{.number = model_number(pass, generation, index), .pass = pass, .generation = generation};
    if (generation > 0) {
      model.parents = {model_number(pass, generation - 1, index), model_number(pass, generation - 1, 0)};
    }
    model.genome = {unit(random), -0.0};
    model.reused = index % 5 == 4;
    if (index % 7 == 3) model.kind = ScoreKind::abandoned;
    const int scored = model.kind == ScoreKind::abandoned ? 1 : pass;
    if (index % 9 == 8) {
      model.kind = ScoreKind::invalid;
      model.reason = "the state is not finite at 0.31 s";
      return model;
    }
    for (int trial = 0; trial < scored; ++trial) model.trial_scores.push_back(unit(random));
    model.score = unit(random) / pass;
    return model;
  }

  TestRow made_up_test(std::mt19937_64& random, int pass, int index) const {
    TestRow test{.number = test_number(pass, index), .pass = pass, .generation = index / 4};
    if (index >= 4) test.parents = {test_number(pass, index - 4), std::nullopt};
    test.genome = {unit(random), kInfinity, unit(random)};
    test.valid = index % 6 != 5;
    if (test.valid) test.fitness = unit(random);
    if (!test.valid) test.reason = "explosion";
    return test;
  }

  TargetTrialRow target_trial(int pass) const {
    return {.number = pass - 1,
            .test = test_number(pass, 1),
            .file = "",
            .for_transfer = false,
            .predicted_fitness = pass == 1 ? kNotKnown : 3.0 - 1.0 / pass,
            .measured_fitness = 3.0 - 2.0 / pass,
            .surprise = pass == 1 ? kNotKnown : 0.25 / pass};
  }

  Trial made_up_trial(int pass) const {
    Trial trial;
    trial.measured = readings(0.1 * pass);
    trial.commands.series = sine(samples, 0.2 * pass);
    trial.commands.series.channels = {{"motor.knee", "rad"}};
    trial.commands.hold = Hold::first_order;
    trial.initial = {{InitialKnowledge::given, 0.1, -0.0}};
    trial.setup = {"heavy", {{"body.load.mass", 1.5}, {"actuator.motor.kp", 400.0}}};
    trial.sensor_noise = {0.002};
    trial.command_noise = {kNotKnown};
    trial.centre_of_mass.channels = {{"x", "m"}, {"y", "m"}, {"z", "m"}};
    trial.centre_of_mass.times = trial.measured.times;
    trial.centre_of_mass.samples = TimeSeries::Samples::Constant(samples, 3, 0.5 * pass);
    return trial;
  }

  PassRow made_up_pass(int pass) const {
    return {.number = pass,
            .best_model = model_number(pass, generations - 1, 0),
            .best_score = 0.5 / pass,
            .best_test = test_number(pass, 1),
            .best_fitness = 1.5 * pass,
            .evaluations = 60,
            .abandoned = 9,
            .reused = 12,
            .invalid = 6,
            .steps = 60'000,
            .test_evaluations = 10,
            .invalid_tests = 1,
            .test_steps = 10'000,
            .best_values = {2.5 + 1.0 / pass, 0.05},
            .objective = {{"body.*.mass", "kg", 1.0 / pass}, {"sensor.*.delay", "s", 0.01}},
            .ensemble = {{model_number(pass, generations - 1, 0), 0.5 / pass, "grease", {2.5 + 1.0 / pass, 0.05}},
                         {model_number(pass, 0, 1), 0.75 / pass, "no optional effect", {3.0, kNotKnown}}},
            .set_aside = {pass - 1},
            .stopped = pass == passes ? "the models no longer improve" : ""};
  }

  void end_pass(EeaStore& store, int pass) const {
    const PassRow row = made_up_pass(pass);
    store.append_prediction(*row.best_model, pass - 1, readings(0.09 * pass), made_up_trial(pass).centre_of_mass);
    store.append(row);
  }

 private:
  static double unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }
};

/// A file with one run of the algorithm, opened as the program opens it.
class MadeUpDatabase {
 public:
  explicit MadeUpDatabase(const std::filesystem::path& file) : database(Database::open(file)) {
    run = results.begin_run({.command = "lacuna run quadruped.toml", .seed = 3, .threads = 2}, {});
    experiment = results.record_experiment({"quadruped", "quadruped.toml", "[experiment]\n", {}});
    store.emplace(database, writing, run, experiment);
  }

  /// All commits before `end`, from where the run stands.
  void advance(const MadeUpRun& made_up, int end) {
    store->begin(made_up.record());
    const std::optional<CheckpointRow> checkpoint = store->checkpoint();
    for (int i = checkpoint ? static_cast<int>(checkpoint->state.at(0)) : 0; i < end; ++i) made_up.commit(*store, i);
  }

  Database database;
  std::mutex writing;
  ResultStore results{database};
  RunId run;
  ExperimentId experiment;
  std::optional<EeaStore> store;
};

/// A finished run beside what else there is, for the examples of the documentation.
inline void add_made_up_run(Database& database) {
  const MadeUpRun made_up;
  ResultStore results(database);
  const RunId run = results.begin_run({.command = "lacuna run quadruped.toml", .seed = 3, .threads = 2}, {});
  const ExperimentId experiment = results.record_experiment({"quadruped", "quadruped.toml", "[experiment]\n", {}});
  std::mutex writing;
  EeaStore store(database, writing, run, experiment);
  store.begin(made_up.record());
  for (int i = 0; i < made_up.commits(); ++i) made_up.commit(store, i);
  store.note_failure({.trial = "1", .test = "12", .reason = "the rig does not answer"});
  store.end(RunEnding::done);
}

}  // namespace lacuna::test
