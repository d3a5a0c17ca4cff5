#include "storage/made_up_run.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

using lacuna::test::MadeUpRun;

/// As a run of the paper: with all its passes some 31 000 tests, 40 000 models and 335 000 scores.
constexpr MadeUpRun kPaperRun{.passes = 20, .generations = 31, .models = 64, .tests = 1550, .samples = 1000};

std::int64_t scores_of(const MadeUpRun& run) {
  std::mt19937_64 random;
  std::int64_t scores = 0;
  for (int pass = 1; pass <= run.passes; ++pass)
    for (int i = 0; i < run.models; ++i)
      scores += run.generations * static_cast<std::int64_t>(run.made_up_model(random, pass, 0, i).trial_scores.size());
  return scores;
}

/// With the fewest passes that store so many scores, and in these the fewest models; at most a run of the paper.
MadeUpRun run_with(std::int64_t scores) {
  MadeUpRun run = kPaperRun;
  run.passes = 1;
  while (run.passes < kPaperRun.passes && scores_of(run) < scores) ++run.passes;
  for (MadeUpRun fewer = run; fewer.models > 1 && scores_of(fewer) >= scores; --fewer.models) run = fewer;
  return run;
}

void add_run(lacuna::Database& database, int replicate, const MadeUpRun& made_up) {
  lacuna::ResultStore results(database);
  const lacuna::RunId run = results.begin_run({.command = "lacuna run quadruped.toml", .seed = 3, .threads = 2}, {});
  const auto experiment = results.record_experiment({"quadruped", "quadruped.toml", "[experiment]\n", {}});
  std::mutex writing;
  lacuna::EeaStore store(database, writing, run, experiment);
  lacuna::EeaRunRecord record = made_up.record();
  record.replicate = replicate;
  store.begin(record);
  for (int i = 0; i < made_up.commits(); ++i) made_up.commit(store, i);
  store.end(lacuna::RunEnding::done);
}

}  // namespace

/// Writes a database with runs of the algorithm that have SCORES scores of models together, or a few more, and prints
/// how many there are: make_grown_database FILE SCORES.
int main(int argc, char** argv) {
  const std::int64_t wanted = argc == 3 ? std::atoll(argv[2]) : 0;
  if (wanted < 1) {
    std::fputs("usage: make_grown_database FILE SCORES\n", stderr);
    return 2;
  }
  lacuna::Database database = lacuna::Database::open(argv[1]);
  lacuna::ResultStore store(database);
  lacuna::test::fill_small_database(store);
  std::int64_t scores = 0;
  for (int replicate = 1; scores < wanted; ++replicate) {
    const MadeUpRun run = run_with(wanted - scores);
    add_run(database, replicate, run);
    scores += scores_of(run);
  }
  std::printf("%lld\n", static_cast<long long>(scores));
}
