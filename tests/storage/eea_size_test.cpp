#include "storage/asked.h"
#include "storage/core/statement.h"
#include "storage/made_up_run.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>

namespace lacuna {
namespace {

using test::ask;
using test::MadeUpDatabase;

constexpr double kSecondsOfARun = 2000.0;    ///< of the paper, on a quiet machine
constexpr double kShare = 0.005;             ///< of that, for storing; 0.003 measured
constexpr double kSecondsOfACommit = 0.005;  ///< of a processor; the disk has to be waited for besides
constexpr double kBusyMachine = 6.0;         ///< times as long for a clock on the wall

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double seconds_of(const auto& action) {
  const auto begin = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

constexpr const char* kLastButOneRun =
    "INSERT INTO run VALUES (8388606, '00112233445566778899aabbccddeeff', NULL, '', 1, 1, '', NULL, NULL)";

/// As many models, tests and scores as a run of the paper: 20 passes of 31 generations of 50 new ones.
struct PaperRun {
  static constexpr int kPasses = 20;
  static constexpr int kGenerations = 31;
  static constexpr int kNew = 50;
  static constexpr std::size_t kModelGenes = 17;
  static constexpr std::size_t kTestGenes = 68;

  void append_tests(EeaStore& store, int pass, int generation) {
    for (int i = 0; i < kNew; ++i) {
      store.append(TestRow{.number = tests++,
                           .pass = pass,
                           .generation = generation,
                           .parents = {tests > kNew ? std::optional(tests - kNew) : std::nullopt, std::nullopt},
                           .genome = Genome(kTestGenes, 0.1 + static_cast<double>(i)),
                           .fitness = 0.1 + 0.001 * i});
    }
  }
  void append_models(EeaStore& store, int pass, int generation) {
    for (int i = 0; i < kNew; ++i) {
      ModelRow model{.number = models++, .pass = pass, .generation = generation};
      if (models > kNew) model.parents = {models - kNew, models - kNew + 1};
      model.genome = Genome(kModelGenes, 0.1 + static_cast<double>(i));
      model.score = 0.3 + 0.01 * i;
      for (int trial = 0; trial < pass; ++trial) model.trial_scores.push_back(0.1 + 0.01 * trial + 0.001 * i);
      store.append(std::move(model));
    }
  }
  std::uint64_t tests = 0;
  std::uint64_t models = 0;
};

/// Asked through a connection of SQLite's own: those of the program have no table of sizes.
double bytes_of_table(const std::filesystem::path& file, const std::string& table) {
  sqlite3* plain = nullptr;
  double bytes = 0.0;
  const auto take = [](void* sum, int, char** values, char**) {
    *static_cast<double*>(sum) = std::atof(values[0]);
    return 0;
  };
  EXPECT_EQ(sqlite3_open(file.c_str(), &plain), SQLITE_OK);
  const std::string question = "SELECT sum(pgsize) FROM dbstat WHERE name = '" + table + "'";
  EXPECT_EQ(sqlite3_exec(plain, question.c_str(), take, &bytes, nullptr), SQLITE_OK) << sqlite3_errmsg(plain);
  sqlite3_close(plain);
  return bytes;
}

TEST(EeaSize, APaperRunTakesLittleTimeAndFewBytes) {
  const TestFolder folder;
  Database::open(folder / "run.db").execute(kLastButOneRun);
  MadeUpDatabase filled(folder / "run.db");
  ASSERT_EQ(filled.run.value, 8388607) << "whose keys take most bytes";
  const test::MadeUpRun made_up{.samples = 1000};
  PaperRun run;
  filled.store->begin(made_up.record());
  const CheckpointRow checkpoint{std::vector<double>(100 * PaperRun::kTestGenes, 0.3)};
  std::vector<double> commits;
  for (int pass = 1; pass <= PaperRun::kPasses; ++pass) {
    for (int generation = 0; generation < PaperRun::kGenerations; ++generation) {
      run.append_tests(*filled.store, pass, generation);
      filled.store->commit(checkpoint);
    }
    TargetTrialRow trial = made_up.target_trial(pass);
    trial.test = run.tests - 1;
    filled.store->append(trial, made_up.made_up_trial(pass));
    for (int generation = 0; generation < PaperRun::kGenerations; ++generation) {
      run.append_models(*filled.store, pass, generation);
      const double before = processor_seconds();
      filled.store->commit(checkpoint);
      if (pass == PaperRun::kPasses) commits.push_back(processor_seconds() - before);
    }
  }
  EXPECT_EQ(ask(filled.database, "SELECT count(*) FROM model_score"), 325'500);
  EXPECT_EQ(ask(filled.database, "SELECT count(*) FROM model"), 31'000);
  EXPECT_EQ(ask(filled.database, "SELECT count(*) FROM test"), 31'000);

  std::nth_element(commits.begin(), commits.begin() + 15, commits.end());
  RecordProperty("seconds_in_all", std::to_string(filled.store->seconds()));
  RecordProperty("processor_seconds_a_commit_of_1000_scores", std::to_string(commits[15]));
  EXPECT_LT(filled.store->seconds(), kShare * kSecondsOfARun * kBusyMachine);
  EXPECT_LT(commits[15], kSecondsOfACommit) << "the median";

  const double bytes = bytes_of_table(filled.database.file(), "model_score");
  RecordProperty("bytes_a_score", std::to_string(bytes / 325'500));
  EXPECT_LE(bytes / 325'500, 40.0);
  EXPECT_GE(bytes / 325'500, 20.0) << "less than its numbers need: the test measures something else";
  std::string hash;
  const double hashing = seconds_of([&] { hash = content_hash(filled.database, filled.run); });
  RecordProperty("seconds_of_hashing", std::to_string(hashing));
  EXPECT_LT(hashing, kBusyMachine);
}

}  // namespace
}  // namespace lacuna
