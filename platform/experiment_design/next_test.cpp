#include "experiment_design/next_test.h"

#include "experiment_design/test_judge.h"
#include "experiment_design/test_line.h"
#include "fitting/numerics/progress_meter.h"
#include "foundation/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr double kRandomShare = 0.6;  ///< of the budget
constexpr int kFewestRandom = 5;
constexpr std::size_t kRefined = 4;         ///< tests that have children
constexpr std::size_t kBatch = 8;           ///< evaluations between two checks for interruption
constexpr double kFirstStep = 0.3;          ///< of a gene's range, in the first generation of children
constexpr double kLastStep = 0.05;          ///< in the last one
constexpr double kMoreThanEnough = 1000.0;  ///< nats
constexpr double kOtherChoice = 0.2;        ///< chance that a whole-number gene changes

struct DrawnTest {
  Genome genome;
  std::size_t setup = 0;  ///< of the task's
  double nats = -1.0;     ///< below 0: the test cannot be carried out
};

bool better(const DrawnTest& a, const DrawnTest& b) { return a.nats > b.nats; }

class TestSearch {
 public:
  explicit TestSearch(const NextTestTask& task)
      : task_(task), judge_(task), random_(std::vector<std::uint64_t>{task.seed}), meter_(task.work.progress) {}

  NextTest run() {
    const int budget = std::max(task_.evaluations, kFewestRandom);
    const int random = std::max(kFewestRandom, static_cast<int>(kRandomShare * budget));
    meter_.set_parts(budget);
    std::vector<DrawnTest> drawn = random_tests(random);
    evaluate(drawn);
    std::vector<DrawnTest> ranked = drawn;
    std::stable_sort(ranked.begin(), ranked.end(), better);
    if (ranked.front().nats < 0.0)
      throw Error(fmt::format(
          "none of {} random tests can be carried out on both {} and {}; check the values of these two models", random,
          task_.candidates[0].name, task_.candidates[1].name));
    const DrawnTest typical = median(ranked);
    refine(ranked, budget - random);
    return describe(ranked.front(), typical);
  }

 private:
  std::vector<DrawnTest> random_tests(int count) {
    std::vector<DrawnTest> tests;
    for (int i = 0; i < count; ++i)
      tests.push_back({judge_.random(random_), static_cast<std::size_t>(i) % task_.setups.size()});
    return tests;
  }

  /// The median of those that can be carried out; `ranked` is sorted and has one.
  static DrawnTest median(const std::vector<DrawnTest>& ranked) {
    const auto end = std::find_if(ranked.begin(), ranked.end(), [](const DrawnTest& one) { return one.nats < 0.0; });
    return ranked[static_cast<std::size_t>((end - ranked.begin()) / 2)];
  }

  void add(std::vector<DrawnTest> tests, std::vector<DrawnTest>& ranked) {
    evaluate(tests);
    ranked.insert(ranked.end(), tests.begin(), tests.end());
    std::stable_sort(ranked.begin(), ranked.end(), better);
  }

  /// Tries the best commands in every other setup, within the budget. Returns the number of evaluations.
  int try_other_setups(std::vector<DrawnTest>& ranked, int budget) {
    std::vector<DrawnTest> others;
    const DrawnTest best = ranked.front();
    for (std::size_t s = 0; s < task_.setups.size() && static_cast<int>(others.size()) < budget; ++s)
      if (s != best.setup) others.push_back({best.genome, s});
    const int count = static_cast<int>(others.size());
    if (count > 0) add(std::move(others), ranked);
    return count;
  }

  void refine(std::vector<DrawnTest>& ranked, int budget) {
    for (int done = try_other_setups(ranked, budget / 2); done < budget;) {
      ranked.resize(std::min(ranked.size(), kRefined));
      const double step = kFirstStep * std::pow(kLastStep / kFirstStep, static_cast<double>(done) / budget);
      std::vector<DrawnTest> children;
      for (std::size_t i = 0; i < kBatch && done < budget; ++i, ++done)
        children.push_back(
            {sayable(task_.space, changed(ranked[i % ranked.size()].genome, step)), ranked[i % ranked.size()].setup});
      add(std::move(children), ranked);
    }
  }

  Genome changed(Genome genome, double step) {
    for (std::size_t i = 0; i < genome.size(); ++i) {
      const Gene& gene = judge_.layout().genes[i];
      if (gene.kind == GeneKind::integer) {
        const bool other = random_.chance(kOtherChoice);
        if (other) genome[i] = uniform_value(gene, random_);
      } else if (gene.unit == "Hz") {
        const double decades = std::log(gene.upper / gene.lower);
        genome[i] = std::clamp(genome[i] * std::exp(step * decades * random_.normal()), gene.lower, gene.upper);
      } else {
        genome[i] = reflected_value(gene, genome[i] + step * (gene.upper - gene.lower) * random_.normal());
      }
    }
    return genome;
  }

  void evaluate(std::vector<DrawnTest>& tests) {
    for (std::size_t begin = 0; begin < tests.size(); begin += kBatch) {
      task_.work.stop.throw_if_due();
      const std::size_t end = std::min(begin + kBatch, tests.size());
      parallel_for(end - begin, task_.work.threads, [&](std::size_t i, int worker) {
        DrawnTest& test = tests[begin + i];
        test.nats = judge_.nats(test.genome, worker, setup_of(test).name());
      });
      for (std::size_t i = begin; i < end; ++i) {
        meter_.begin_part("next test");
        meter_.end_part();
        ++evaluations_;
        invalid_ += tests[i].nats < 0.0 ? 1 : 0;
      }
    }
  }

  const KnownSetup& setup_of(const DrawnTest& test) const { return task_.setups[test.setup]; }

  NextTest describe(const DrawnTest& best, const DrawnTest& typical) const {
    NextTest test;
    test.line = test_line(task_.space, best.genome);
    if (any_is_set(task_.setups)) test.setup = setup_of(best);
    test.candidates = {task_.candidates[0].name, task_.candidates[1].name};
    test.nats = best.nats;
    test.random_nats = typical.nats;
    test.trials = judge_.trials_needed(best.genome, setup_of(best).name());
    test.random_trials = judge_.trials_needed(typical.genome, setup_of(typical).name());
    test.evaluations = evaluations_;
    test.invalid = invalid_;
    return test;
  }

  const NextTestTask& task_;
  TestJudge judge_;
  RandomStream random_;
  ProgressMeter meter_;
  int evaluations_ = 0;
  int invalid_ = 0;
};

std::string trials_text(double trials) {
  if (std::isinf(trials)) return "no number of trials";
  return fmt::format("{:g} trial{}", trials, trials == 1.0 ? "" : "s");
}

/// Beyond this bound the exact worth is not known and does not matter.
std::string worth_text(double nats) {
  return nats > kMoreThanEnough ? fmt::format("more than {:g}", kMoreThanEnough) : fmt::format("{:.3g}", nats);
}

}  // namespace

NextTest next_test(const NextTestTask& task) { return TestSearch(task).run(); }

std::string to_string(const NextTest& test) {
  return fmt::format(
      "{}{}: {} nats of evidence per trial (a random test: {}), {} for odds of 150 to 1, {:g} nats (a random test: {})",
      test.line, test.setup ? " with " + setup_text(*test.setup) : "", worth_text(test.nats),
      worth_text(test.random_nats), trials_text(test.trials), kDecisiveNats, trials_text(test.random_trials));
}

}  // namespace lacuna
