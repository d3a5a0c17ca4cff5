#include "baselines/baselines.h"

#include "baselines/cross_validated_refit.h"
#include "baselines/effective_bic.h"
#include "baselines/random_guess.h"
#include "baselines/regressors.h"
#include "baselines/residual_correlation.h"
#include "baselines/stepwise_regression.h"
#include "plant/draw.h"

namespace hidden_effects {
namespace {

constexpr std::size_t kTries = 8;       ///< of a candidate, for the screening
constexpr std::size_t kMostFits = 12;   ///< candidates that are refitted
constexpr std::uint64_t kStream = 700;  ///< of a case's seed, for guessing

}  // namespace

std::vector<BaselineAnswer> run_baselines(const Observed& seen, std::uint64_t seed) {
  const ProcessorTime looking;
  const RecordedMotions motions = recorded_motions(seen);
  const std::vector<Candidate> candidates = all_candidates(seen, motions);
  const double looked = looking.seconds();

  const ProcessorTime screening;
  const BaseFit base = fit_base(seen, {seen.nominal(), Regression(seen, motions).fitted_base()});
  const std::vector<EffectSignal> signals = effect_signals(seen, base, candidates, kTries);
  const double screened = looked + screening.seconds();

  const ProcessorTime fitting;
  const std::vector<std::size_t> order = by_partial_correlation(candidates.size(), signals);
  const std::vector<CandidateFit> fits = fit_candidates(seen, base, candidates, signals, order, kMostFits);
  const double fitted = screened + fitting.seconds();

  const auto timed = [](double before, const auto& answer_of) {
    const ProcessorTime own;
    BaselineAnswer answer = answer_of();
    answer.seconds = before + own.seconds();
    return answer;
  };
  return {timed(fitted, [&] { return by_cross_validated_refit(seen, base, candidates, fits, order); }),
          timed(fitted, [&] { return by_effective_bic(base, candidates, fits, order); }),
          timed(looked, [&] { return by_stepwise_regression(seen, motions, candidates); }),
          timed(screened, [&] { return by_residual_correlation(candidates, signals); }),
          timed(looked, [&] { return by_random_guess(candidates, seed); })};
}

std::vector<BaselineAnswer> run_baselines(const MadeCase& made, const std::vector<std::string>& withheld) {
  return run_baselines(observed(made, withheld), mixed(made.plan.seed, kStream));
}

}  // namespace hidden_effects
