#include "app/workspace/rig.h"
#include "search/find_missing.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>

/// What is missing from an experiment's model, searched by horizon: the lengths, then every set that was fitted to all
/// segments, by what it leaves where it was not fitted and on what is held out, relative to the model as it is. The
/// arrow is the answer.
///
///   bench_search EXPERIMENT.toml [EFFECT ...]
namespace lacuna {
namespace {

/// Relative to the model as it is; nothing where there is nothing to predict.
std::string ratio(bool is_known, double cost, double of_base) {
  return is_known ? fmt::format("×{:.3f}", std::exp(cost - of_base)) : "–";
}

void print(const RankedSet& set, const RankedSet& base, bool is_answer) {
  const std::string name = name_of_set(set.model.added);
  const bool is_held_out = set.held_out.valid && base.held_out.valid;
  fmt::print("{} {} {} {} · {:.3f} ± {:.3f} nats over the answer\n", is_answer ? "→" : " ",
             ratio(true, set.cost, base.cost), ratio(is_held_out, set.held_out.cost, base.held_out.cost),
             name.empty() ? "the model as it is" : name, set.over_answer.nats, set.over_answer.error);
}

void run(const char* file, const std::vector<std::string>& among) {
  const auto begin = std::chrono::steady_clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  CommonOptions options;
  options.experiment = file;
  const Rig rig = open_rig(options);
  MissingTask task{rig.experiment, *rig.catalog, rig.trials, rig.definition.start_values()};
  task.among = among;
  task.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  task.note = [&](const std::string& what) { fmt::print(stderr, "{:.1f} s {}\n", spent(), what); };
  const Missing missing = find_missing(Ground(task));
  fmt::print("{}: lengths", file);
  for (const Rung& rung : missing.ladder.rungs) fmt::print(" {:.3g}", rung.length);
  fmt::print(" s\n");
  for (std::size_t r = 0; r < missing.ladder.rungs.size(); ++r)
    for (std::size_t c = 0; c < missing.ladder.channels.size(); ++c) {
      const Rung& rung = missing.ladder.rungs[r];
      if (rung.weight[c] > 0.0)
        fmt::print("  {} {:.3g} s: {:.3g} → {:.3g}, floor {:.3g}, weight {:.3f}, {} segments\n",
                   missing.ladder.channels[c].channel, rung.length, std::sqrt(missing.base.errors.mean_square[r][c]),
                   std::sqrt(missing.ranking[missing.answer].errors.mean_square[r][c]), std::sqrt(rung.floor[c]),
                   rung.weight[c], rung.segments.size());
    }
  for (std::size_t i = 0; i < missing.ranking.size(); ++i) print(missing.ranking[i], missing.base, i == missing.answer);
  fmt::print("{} refits, {:.0f} s\n", missing.refits, spent());
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "bench_search EXPERIMENT.toml [EFFECT ...]\n");
    return EXIT_FAILURE;
  }
  try {
    lacuna::run(argv[1], {argv + 2, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
