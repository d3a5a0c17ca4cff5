#include "bench/bare_quadruped.h"
#include "bench/platform_quadruped.h"
#include "bench/scored_quadruped.h"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// Steps per second of the platform's loop, and of the loop that scores models, against a bare ODE loop of the same
/// quadruped. They take turns, and a ratio is that of medians. Exit code 1 where the two do not move alike.
namespace lacuna {
namespace {

constexpr int kTrialSteps = 1000;
constexpr int kShortTrialSteps = 20;

template <class Quadruped>
void run_trials(benchmark::State& state) {
  const int steps = static_cast<int>(state.range(0));
  Quadruped quadruped;
  quadruped.run(steps);  // what is made once is no part of the loop
  for ([[maybe_unused]] auto _ : state) quadruped.run(steps);
  const double done = static_cast<double>(state.iterations()) * steps;
  state.counters["steps"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
}

void bare(benchmark::State& state) { run_trials<BareQuadruped>(state); }
void platform(benchmark::State& state) { run_trials<PlatformQuadruped>(state); }
void scored(benchmark::State& state) { run_trials<ScoredQuadruped>(state); }

BENCHMARK(bare)->Arg(kTrialSteps)->Arg(kShortTrialSteps)->Unit(benchmark::kMicrosecond);
BENCHMARK(platform)->Arg(kTrialSteps)->Arg(kShortTrialSteps)->Unit(benchmark::kMicrosecond);
BENCHMARK(scored)->Arg(kTrialSteps)->Arg(kShortTrialSteps)->Unit(benchmark::kMicrosecond);

/// Prints as usual, and keeps the rates of the single repetitions.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  RatioReporter() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        rates_[run.run_name.function_name + "/" + run.run_name.args].push_back(run.counters.at("steps"));
  }

  void print_ratio(int steps) {
    const double theirs = median("bare/" + std::to_string(steps));
    for (const std::string loop : {"platform", "scored"}) {
      const double ours = median(loop + "/" + std::to_string(steps));
      if (theirs > 0.0)
        fmt::print("trials of {} steps: {} {:.0f} steps/s, bare ODE {:.0f} steps/s, ratio {:.3f}\n", steps, loop, ours,
                   theirs, ours / theirs);
    }
  }

 private:
  double median(const std::string& name) {
    std::vector<double>& rates = rates_[name];
    if (rates.empty()) return 0.0;
    std::ranges::sort(rates);
    return rates[rates.size() / 2];
  }

  std::map<std::string, std::vector<double>> rates_;
};

/// The largest difference of any reading in the first half second, in which the motion is not yet chaotic.
double largest_difference() {
  constexpr int kSteps = 50;
  BareQuadruped bare_one;
  PlatformQuadruped platform_one;
  bare_one.run(kSteps);
  platform_one.run(kSteps);
  const auto& samples = platform_one.result().readings.samples;
  double largest = 0.0;
  for (Eigen::Index i = 0; i < samples.size(); ++i)
    largest = std::max(largest, std::abs(samples.data()[i] - bare_one.readings()[static_cast<std::size_t>(i)]));
  return largest;
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
  constexpr double kSameMotion = 1e-3;  // rad, m
  std::vector<std::string> defaults{"--benchmark_repetitions=15", "--benchmark_min_time=0.1",
                                    "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> arguments{argv[0]};
  for (std::string& text : defaults) arguments.push_back(text.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);  // of two of a kind the last one counts
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;

  const double difference = lacuna::largest_difference();
  fmt::print("largest difference of a reading in the first 50 steps: {:.2g}\n", difference);
  lacuna::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_ratio(lacuna::kTrialSteps);
  reporter.print_ratio(lacuna::kShortTrialSteps);
  return difference <= kSameMotion ? 0 : 1;
}
