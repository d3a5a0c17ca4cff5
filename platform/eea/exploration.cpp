#include "eea/exploration.h"

#include "eea/definition/evaluations.h"
#include "evolution/search_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kWorstTest = std::numeric_limits<double>::infinity();

/// One exploration phase.
class Exploration {
 public:
  Exploration(const EeaRun& run, EeaState& state) : run_(run), definition_(run.definition), state_(state) {}

  void run() {
    begin();
    run_search(
        *search_, definition_.exploration.strategy.origin,
        [this](const auto& individuals, auto) { return score(individuals); }, [this] { end(); });
    hand_on();
  }

 private:
  void begin() {
    const std::uint64_t steps = run_.evaluations->begin_exploration(state_);
    const Chosen<SearchStrategy>& strategy = definition_.exploration.strategy;
    const SearchTask task{definition_.exploration.layout(),
                          *definition_.exploration.breeder,
                          run_.key(Phase::exploration, state_.pass),
                          {}};
    search_ = guarded_call(strategy.origin, "begin", [&] { return strategy->begin(task, strategy.parameters); });
    if (state_.search.empty()) {
      state_.search_begin = state_.tests;
      state_.counts.test_steps += steps;
    } else {
      guarded_call(strategy.origin, "load", [&] { search_->load(state_.search); });
    }
  }

  /// Searches minimise; the fitness of a test is to be large.
  std::vector<double> score(const std::vector<Individual>& individuals) {
    std::vector<Genome> tests;
    for (const Individual& individual : individuals) tests.push_back(individual.genome);
    const std::vector<JudgedTest> judged = run_.evaluations->judge(tests);
    std::vector<double> scores;
    for (std::size_t i = 0; i < individuals.size(); ++i) {
      const bool valid = judged[i].reason.empty();
      scores.push_back(valid ? -judged[i].fitness : kWorstTest);
      ++state_.counts.test_evaluations;
      state_.counts.invalid_tests += valid ? 0 : 1;
      state_.counts.test_steps += judged[i].steps;
      note(individuals[i], judged[i]);
    }
    return scores;
  }

  void note(const Individual& individual, const JudgedTest& judged) {
    TestRow row;
    row.number = state_.search_begin + individual.number;
    row.pass = state_.pass;
    row.generation = search_->generation();
    for (std::size_t i = 0; i < std::min(row.parents.size(), individual.parents.size()); ++i)
      row.parents[i] = state_.search_begin + individual.parents[i];
    row.genome = individual.genome;
    row.valid = judged.reason.empty();
    row.fitness = row.valid ? judged.fitness : kNotKnown;
    row.reason = judged.reason;
    if (!row.reason.empty()) last_reason_ = row.reason;
    state_.tests = std::max(state_.tests, row.number + 1);
    run_.journal.add(std::move(row));
  }

  void end() {
    state_.search = guarded_call(definition_.exploration.strategy.origin, "save", [&] { return search_->save(); });
    const std::vector<ScoredIndividual> best = search_->best();
    run_.end_generation(state_, {.pass = state_.pass,
                                 .passes = definition_.passes,
                                 .phase = Phase::exploration,
                                 .generation = search_->generation(),
                                 .generations = search_->generations(),
                                 .best = best.empty() ? -kWorstTest : -best.front().score,
                                 .evaluations = state_.counts.evaluations + state_.counts.test_evaluations,
                                 .invalid = state_.counts.invalid + state_.counts.invalid_tests});
  }

  void hand_on() {
    const std::vector<ScoredIndividual> best = search_->best();
    if (best.empty() || !std::isfinite(best.front().score)) {
      run_.journal.checkpoint(state_, true);  // together with the rows that give the reasons
      throw Error("pass " + std::to_string(state_.pass) + ": none of " +
                  std::to_string(state_.counts.test_evaluations) + " tests can be carried out on the model; " +
                  (last_reason_.empty() ? "" : "the last one: " + last_reason_ + "; ") +
                  "the view invalid_evaluations lists the reasons");
    }
    state_.search.clear();
    const Individual& individual = best.front().individual;
    state_.next_test = PendingTest{state_.search_begin + individual.number, individual.genome, -best.front().score};
    state_.counts.best_test = state_.next_test->number;
    state_.counts.best_fitness = state_.next_test->predicted_fitness;
  }

  const EeaRun& run_;
  const EeaDefinition& definition_;
  EeaState& state_;
  std::unique_ptr<Search> search_;
  std::string last_reason_;  ///< why a test was invalid
};

}  // namespace

void explore(const EeaRun& run, EeaState& state) {
  const TestValue& value = run.definition.value;
  if (value.models() > 0 && !(value.takes_trials() && state.trials.empty()))
    Exploration(run, state).run();
  else
    choose_random_test(run, state, 0);
}

void choose_random_test(const EeaRun& run, EeaState& state, int attempt) {
  std::vector<std::uint64_t> key = run.key(Phase::trial, state.pass);
  key.push_back(static_cast<std::uint64_t>(attempt));
  RandomStream random(key);
  TestRow row;
  row.number = state.tests++;
  row.pass = state.pass;
  row.genome = run.definition.exploration.breeder->random(random);
  state.next_test = PendingTest{row.number, row.genome, kNotKnown};
  run.journal.add(std::move(row));
}

}  // namespace lacuna
