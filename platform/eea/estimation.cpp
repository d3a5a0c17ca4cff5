#include "eea/estimation.h"

#include "evaluation/model_evaluator.h"
#include "evaluation/test_predictor.h"
#include "evolution/search_run.h"

#include <algorithm>
#include <limits>

namespace lacuna {
namespace {

constexpr double kWorst = std::numeric_limits<double>::infinity();

std::vector<ScoredTrial> scored_trials(const EeaDefinition& definition, const EeaState& state) {
  std::vector<ScoredTrial> scored;
  for (const TargetTrial& trial : state.trials) scored.push_back(definition.scored(trial.drive, trial.trial));
  return scored;
}

EvaluationKind kind_of(ScoreKind kind) {
  switch (kind) {
    case ScoreKind::full: return EvaluationKind::full;
    case ScoreKind::abandoned: return EvaluationKind::abandoned;
    case ScoreKind::invalid: return EvaluationKind::invalid;
  }
  return EvaluationKind::invalid;
}

ModelScore score_of(const ModelRow& row) {
  ModelScore score;
  score.total = row.kind == EvaluationKind::invalid ? kWorst : row.score;
  score.trials = row.trial_scores;
  score.kind = row.kind == EvaluationKind::full        ? ScoreKind::full
               : row.kind == EvaluationKind::abandoned ? ScoreKind::abandoned
                                                       : ScoreKind::invalid;
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
        scorer_(*definition_.compiled, scored_trials(definition_, state), definition_.metric, run.threads,
                &definition_.model),
        evaluator_(scorer_, definition_.model, {definition_.abandon, definition_.reuse}) {}

  void run() {
    begin();
    run_search(
        *search_, definition_.estimation.strategy.origin,
        [this](const auto& individuals, auto bar) { return score(individuals, bar); }, [this] { end(); });
    hand_on();
  }

 private:
  void begin() {
    const Chosen<SearchStrategy>& strategy = definition_.estimation.strategy;
    SearchTask task{
        definition_.estimation.layout(), *definition_.estimation.breeder, run_.key(Phase::estimation, state_.pass), {}};
    const auto seeds = std::min(state_.best.size(), static_cast<std::size_t>(definition_.seeds));
    for (std::size_t i = 0; i < seeds; ++i)
      if (!state_.best[i].genome.empty()) task.seeds.push_back(state_.best[i].genome);  // an approximate model has none
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

  /// What the encoding cannot decode is invalid, and not simulated.
  std::vector<EvaluatedModel> evaluate(const std::vector<Individual>& individuals, std::optional<double> bar) {
    std::vector<EvaluatedModel> evaluated(individuals.size());
    std::vector<ModelProposal> models;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < individuals.size(); ++i) {
      DecodedModel model = decode_model(individuals[i].genome);
      if (model.reason.empty()) {
        models.push_back(std::move(model.model));
        places.push_back(i);
      } else {
        evaluated[i].score = {
            .total = kWorst, .trials = {}, .kind = ScoreKind::invalid, .reason = std::move(model.reason)};
      }
    }
    std::vector<EvaluatedModel> simulated = evaluator_.evaluate(models, bar);
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
    row.kind = kind_of(evaluated.score.kind);
    row.reused = evaluated.reused;
    row.score = row.kind == EvaluationKind::invalid ? kNotKnown : evaluated.score.total;
    row.trial_scores = std::move(evaluated.score.trials);
    row.reason = std::move(evaluated.score.reason);
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

  void hand_on() {
    const std::vector<ScoredIndividual> found = search_->best();
    if (found.empty() || !std::isfinite(found.front().score)) {
      run_.journal.checkpoint(state_, true);  // with the rows that say why
      throw Error("pass " + std::to_string(state_.pass) + ": no model of " + std::to_string(state_.counts.evaluations) +
                  " can be scored; the view invalid_evaluations says why");
    }
    state_.best.clear();
    for (const ScoredIndividual& scored : found) {
      if (!std::isfinite(scored.score)) break;  // those that cannot be scored come last; they judge no test
      const Individual& individual = scored.individual;
      state_.best.push_back({state_.search_begin + individual.number, individual.genome,
                             definition_.decode_model(individual.genome), scored.score});
    }
    state_.search.clear();
  }

  const EeaRun& run_;
  const EeaDefinition& definition_;
  EeaState& state_;
  ModelScorer scorer_;
  ModelEvaluator evaluator_;
  std::unique_ptr<Search> search_;
};

}  // namespace

void estimate(const EeaRun& run, EeaState& state) { Estimation(run, state).run(); }

}  // namespace lacuna
