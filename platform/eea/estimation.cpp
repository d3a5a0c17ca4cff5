#include "eea/estimation.h"

#include "eea/ensemble/ensemble.h"
#include "eea/definition/evaluations.h"
#include "eea/new_structure_breeder.h"
#include "eea/trials/scored_trials.h"
#include "evaluation/scoring/model_evaluator.h"
#include "evolution/search_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>

namespace lacuna {
namespace {

constexpr double kWorst = std::numeric_limits<double>::infinity();

ModelScore score_of(const ModelRow& row) {
  ModelScore score;
  score.total = row.kind == ScoreKind::invalid ? kWorst : row.score;
  for (const double of_trial : row.trial_scores)
    if (!std::isnan(of_trial)) score.trials.push_back(of_trial);  // a trial that is set aside has none
  score.kind = row.kind;
  score.reason = row.reason;
  return score;
}

std::array<std::optional<std::uint64_t>, 2> parents_of(const Individual& individual, std::uint64_t begin) {
  std::array<std::optional<std::uint64_t>, 2> parents;
  for (std::size_t i = 0; i < std::min(parents.size(), individual.parents.size()); ++i)
    parents[i] = begin + individual.parents[i];
  return parents;
}

struct DecodedModel {
  ModelProposal model;
  std::string reason;  ///< why there is none
};

/// One estimation phase.
class Estimation {
 public:
  Estimation(const EeaRun& run, EeaState& state)
      : run_(run),
        definition_(run.definition),
        state_(state),
        evaluator_(definition_.model, {definition_.abandon, definition_.reuse}) {}

  void run() {
    run_.evaluations->begin_estimation(state_);
    for (; state_.restart < definition_.restarts; ++state_.restart) {
      breed();
      if (!breeder_->can_breed(key())) break;
      begin();
      run_search(
          *search_, definition_.estimation.strategy.origin,
          [this](const auto& individuals, auto bar) { return score(individuals, bar); }, [this] { end(); });
      keep_found();
    }
    hand_on();
  }

 private:
  void breed() { breeder_.emplace(definition_, definition_.rivals ? structures_found() : std::set<std::string>()); }

  void begin() {
    const Chosen<SearchStrategy>& strategy = definition_.estimation.strategy;
    const SearchTask task{definition_.estimation.layout(), *breeder_, key(), seeds()};
    search_ = guarded_call(strategy.origin, "begin", [&] { return strategy->begin(task, strategy.parameters); });
    if (state_.search.empty()) {
      state_.search_begin = state_.models;
      return;
    }
    guarded_call(strategy.origin, "load", [&] { search_->load(state_.search); });
    for (const ModelRow& row : state_.evaluated)
      if (const DecodedModel model = decode_model(row.genome); model.reason.empty())
        evaluator_.remember(model.model, score_of(row));
    state_.evaluated.clear();
  }

  /// Each restart has its own random numbers; the first has those of a phase without restarts.
  std::vector<std::uint64_t> key() const {
    std::vector<std::uint64_t> key = run_.key(Phase::estimation, state_.pass);
    if (state_.restart > 0) key.push_back(static_cast<std::uint64_t>(state_.restart));
    return key;
  }

  /// From the best models of the earlier restarts.
  std::set<std::string> structures_found() const {
    std::set<std::string> structures;
    int restart = -1;
    for (const KnownModel& known : state_.found)  // of each restart, best first
      if (std::exchange(restart, known.restart) != known.restart) structures.insert(known.model.structure);
    return structures;
  }

  /// The best models of the previous pass seed the first search. Other searches start from random models, so that a
  /// phase does not depend on one lineage, unless they look for other structures, which have their own seeds. An
  /// approximate model has no genome.
  std::vector<Genome> seeds() const {
    std::vector<Genome> seeds;
    if (state_.restart > 0 && !definition_.rivals) return seeds;
    for (const KnownModel& known : state_.best)
      if (seeds.size() < static_cast<std::size_t>(definition_.seeds) && !known.genome.empty() &&
          !breeder_->is_taken(known.model))
        seeds.push_back(known.genome);
    return seeds;
  }

  std::vector<double> score(const std::vector<Individual>& individuals, std::optional<double> bar) {
    std::vector<EvaluatedModel> evaluated = evaluate(individuals, bar);
    std::vector<double> scores;
    for (std::size_t i = 0; i < individuals.size(); ++i) {
      scores.push_back(evaluated[i].score.total);
      count(evaluated[i]);
      note(individuals[i], std::move(evaluated[i]));
    }
    return scores;
  }

  /// A genome that cannot be decoded is invalid and not simulated.
  std::vector<EvaluatedModel> evaluate(const std::vector<Individual>& individuals, std::optional<double> bar) {
    std::vector<EvaluatedModel> evaluated(individuals.size());
    std::vector<ModelProposal> models;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < individuals.size(); ++i) {
      DecodedModel model = decode_model(individuals[i].genome);
      if (model.reason.empty() && breeder_->is_taken(model.model))
        model.reason = "its structure was examined by an earlier restart, " + model.model.structure;
      if (model.reason.empty()) {
        models.push_back(std::move(model.model));
        places.push_back(i);
      } else {
        evaluated[i].score = {
            .total = kWorst, .trials = {}, .kind = ScoreKind::invalid, .reason = std::move(model.reason)};
      }
    }
    const auto simulate = [&](std::span<const std::size_t> fresh, std::optional<double> below) {
      std::vector<CandidateModel> candidates;
      for (const std::size_t i : fresh) candidates.push_back({&individuals[places[i]].genome, &models[i]});
      return run_.evaluations->score(candidates, below);
    };
    std::vector<EvaluatedModel> simulated = evaluator_.evaluate(models, bar, simulate);
    for (std::size_t i = 0; i < places.size(); ++i) evaluated[places[i]] = std::move(simulated[i]);
    return evaluated;
  }

  DecodedModel decode_model(const Genome& genome) const {
    try {
      return {definition_.decode_model(genome), {}};
    } catch (const Error& error) {
      return {{}, error.what()};
    }
  }

  void count(const EvaluatedModel& evaluated) {
    PassRow& counts = state_.counts;
    ++counts.evaluations;
    counts.steps += evaluated.score.steps;
    counts.reused += evaluated.reused ? 1 : 0;
    counts.abandoned += evaluated.score.kind == ScoreKind::abandoned ? 1 : 0;
    counts.invalid += evaluated.score.kind == ScoreKind::invalid ? 1 : 0;
  }

  void note(const Individual& individual, EvaluatedModel&& evaluated) {
    ModelRow row;
    row.number = state_.search_begin + individual.number;
    row.pass = state_.pass;
    row.generation = search_->generation();
    row.parents = parents_of(individual, state_.search_begin);
    row.genome = individual.genome;
    row.kind = evaluated.score.kind;
    row.reused = evaluated.reused;
    row.score = row.kind == ScoreKind::invalid ? kNotKnown : evaluated.score.total;
    row.trial_scores = by_trial(state_, evaluated.score.trials);
    row.reason = std::move(evaluated.score.reason);
    if (!row.reason.empty()) last_reason_ = row.reason;
    state_.models = std::max(state_.models, row.number + 1);
    run_.journal.add(std::move(row));
  }

  void end() {
    state_.search = guarded_call(definition_.estimation.strategy.origin, "save", [&] { return search_->save(); });
    const std::vector<ScoredIndividual> best = search_->best();
    run_.end_generation(state_, {.pass = state_.pass,
                                 .passes = definition_.passes,
                                 .phase = Phase::estimation,
                                 .generation = search_->generation(),
                                 .generations = search_->generations(),
                                 .best = best.empty() ? kWorst : best.front().score,
                                 .evaluations = state_.counts.evaluations,
                                 .invalid = state_.counts.invalid});
  }

  /// Ranks the models of a finished restart. Those that cannot be scored come last; they judge no test.
  void keep_found() {
    for (const ScoredIndividual& scored : search_->best()) {
      if (!std::isfinite(scored.score)) break;
      const Individual& individual = scored.individual;
      state_.found.push_back({state_.search_begin + individual.number, individual.genome,
                              definition_.decode_model(individual.genome), scored.score, state_.restart});
    }
    state_.search.clear();
  }

  void hand_on() {
    if (state_.found.empty()) {
      run_.journal.checkpoint(state_, true);  // together with the rows that give the reasons
      throw Error("pass " + std::to_string(state_.pass) + ": no model of " + std::to_string(state_.counts.evaluations) +
                  " can be scored; " + (last_reason_.empty() ? "" : "the last one: " + last_reason_ + "; ") +
                  "the view invalid_evaluations lists the reasons");
    }
    state_.best = std::exchange(state_.found, {});
    std::stable_sort(state_.best.begin(), state_.best.end(),
                     [](const KnownModel& a, const KnownModel& b) { return a.score < b.score; });
    state_.restart = 0;
    if (!definition_.profiled.empty()) find_delays();
  }

  void find_delays() {
    std::vector<KnownModel*> handed_on;
    for (const std::size_t i : differing(state_.best, definition_.ensemble, definition_.phenotypes))
      handed_on.push_back(&state_.best[i]);
    std::vector<ModelScore> scores =
        run_.evaluations->find_delays(std::vector<const KnownModel*>(handed_on.begin(), handed_on.end()), state_);
    for (std::size_t i = 0; i < handed_on.size(); ++i) {
      state_.counts.steps += scores[i].steps;
      if (!scores[i].values.empty()) handed_on[i]->model.values = std::move(scores[i].values);
    }
  }

  const EeaRun& run_;
  const EeaDefinition& definition_;
  EeaState& state_;
  ModelEvaluator evaluator_;
  std::optional<NewStructureBreeder> breeder_;  // of the current restart
  std::unique_ptr<Search> search_;              // that uses it
  std::string last_reason_;                     // why a model was invalid
};

}  // namespace

void estimate(const EeaRun& run, EeaState& state) { Estimation(run, state).run(); }

}  // namespace lacuna
