#include "bench/timed_run.h"

#include <lacuna/error.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

/// What a run of the Estimation-Exploration Algorithm costs: its storage, its second thread, and how many steps of the
/// naive loop it saves. Each figure compares two ways that take turns, and is a median.
///
///   bench_run [EXPERIMENT [PASSES [REPETITIONS]]]
namespace lacuna {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2.0;
}

void print(const char* figure, std::vector<double> ratios, const char* goal) {
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  fmt::print("{}: {:.4f} ({:.4f} to {:.4f} in {} repetitions), goal {}\n", figure, median(ratios), *least, *most,
             ratios.size(), goal);
  std::fflush(stdout);
}

void compare_storage(const TimedRun& run, int repetitions) {
  std::vector<double> ratios;
  for (int i = 0; i < repetitions; ++i) {
    const double without = run.unstored(1), with = run.stored(1), with_again = run.stored(1),
                 without_again = run.unstored(1);
    ratios.push_back((with + with_again) / (without + without_again));
  }
  print("time stored / not stored", ratios, "at most 1.03");
}

void compare_threads(const TimedRun& run, int repetitions) {
  std::vector<double> ratios;
  for (int i = 0; i < repetitions; ++i) {
    const double processes = run.two_processes(), threads = run.stored(2), threads_again = run.stored(2);
    ratios.push_back(processes / (threads + threads_again));
  }
  print("speed of two threads / of two processes of one thread", ratios, "at least 0.9");
}

void compare_steps(const TimedRun& run) {
  const RunSteps steps = run.steps();
  fmt::print("steps of the naive loop / steps: {:.3f} ({} / {}), goal at least 2.5\n",
             static_cast<double>(steps.naive) / static_cast<double>(steps.taken), steps.naive, steps.taken);
  fmt::print("  of these: survivors {:.3f}, abandoned and identical models {:.3f}\n",
             static_cast<double>(steps.naive) / static_cast<double>(steps.without_survivors),
             static_cast<double>(steps.without_survivors) / static_cast<double>(steps.taken));
}

int compare_all(int argc, char** argv) {
  const char* experiment = argc > 1 ? argv[1] : LACUNA_SOURCE_DIRECTORY "/experiments/smoke/quadruped-parametric.toml";
  const TimedRun run(experiment, argc > 2 ? std::atoi(argv[2]) : 2);
  const int repetitions = argc > 3 ? std::atoi(argv[3]) : 5;
  compare_steps(run);
  compare_storage(run, repetitions);
  compare_threads(run, repetitions);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
  try {
    return lacuna::compare_all(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return EXIT_FAILURE;
  }
}
