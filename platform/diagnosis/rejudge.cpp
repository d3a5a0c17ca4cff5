#include "diagnosis/rejudge.h"

#include "foundation/parallel.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kClose = 0.5;  ///< of the chosen one's gain: less is no close call
constexpr std::size_t kMostClose = 4;
constexpr std::size_t kMostInseparable = 2;
constexpr double kToldApart = 2.0;  ///< nats: less does not tell two effects apart
/// A close call is judged by gains of this precision, and needs no more iterations.
constexpr double kFineEnough = 1e-3;
constexpr int kIterations = 8;
/// Of the gain: what two models may differ by because the noise is not quite as it is modelled.
constexpr double kAlikeShare = 0.1;

std::vector<std::size_t> close_calls(const SearchStep& step) {
  std::vector<std::size_t> close;
  const double least = std::max(0.0, kClose * step.rivals[step.chosen].gain.value);
  for (std::size_t i = 0; i < step.rivals.size() && close.size() < kMostClose; ++i)
    if (i != step.chosen && step.rivals[i].gain.value > least) close.push_back(i);
  return close;
}

std::vector<Contender> close_models(const RejudgeTask& task, const std::vector<std::size_t>& close) {
  std::vector<Contender> models;
  for (const std::size_t i : close) {
    std::vector<EffectEntry> added = task.before.added;
    added.push_back(task.before.rivals[i].entry);
    models.push_back(with_effects(task.plain, added, task.before.rivals[i].values, task.catalog));
  }
  return models;
}

Refit refit_again(const RejudgeTask& task, const KeptRival& rival, const Contender& model, int threads) {
  BaseSolution base = without_values(task.now.base);
  base.nuisance.clear();
  if (rival.timed) base.nuisance.assign(task.before.timing.begin(), task.before.timing.end());
  return refit({model.definition, *model.model, {}}, base, task.now.bins, task.now.factors, {rival.values}, threads,
               {std::max(RefitEffort().precision, kFineEnough * 2.0 * rival.gain.value), kIterations});
}

/// Whether the chosen effect and one more, with no more parameters than the richer rival, predict as well as it does:
/// what takes the place of two simple effects at once need not be what is there. Equally many parameters must do so
/// within the standard error, fewer may miss a tenth of what the rival adds.
bool a_pair_does_it(const RejudgeTask& task, const KeptRival& richer, const Eigen::VectorXd& held_out) {
  const Round& now = task.now;
  const std::size_t most = richer.values.size(), base = task.before.rivals[task.before.chosen].values.size();
  const double added = gain(now.held_out, held_out, task.seed).value;
  for (const Rival& further : now.rivals) {
    const std::size_t pair = base + now.hypotheses[further.hypothesis].own.size();
    if (pair > most) continue;
    const Gain behind = gain(further.held_out, held_out, task.seed);
    const double share = pair < most ? kAlikeShare * added : 0.0;
    if (behind.value <= std::max({kToldApart, behind.standard_error, share})) return true;
  }
  return false;
}

}  // namespace

Rejudged rejudge(const RejudgeTask& task) {
  const SearchStep& before = task.before;
  const KeptRival& chosen = before.rivals[before.chosen];
  const std::vector<std::size_t> close = close_calls(before);
  const std::vector<Contender> models = close_models(task, close);
  std::vector<Refit> fits(close.size());
  const int inner = std::max(1, task.threads / static_cast<int>(std::max<std::size_t>(close.size(), 1)));
  parallel_for(close.size(), task.threads,
               [&](std::size_t i, int) { fits[i] = refit_again(task, before.rivals[close[i]], models[i], inner); });
  const double alike = std::max(kToldApart, kAlikeShare * chosen.gain.value);
  Rejudged result;
  double most = 0.0;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < close.size(); ++i) {
    if (!fits[i].valid) continue;
    const Eigen::VectorXd held_out = held_out_deviance(fits[i], task.now.folds);
    const Gain ahead = gain(task.now.held_out, held_out, task.seed);
    if (ahead.upper_95 >= 0.0 || ahead.value > -alike) order.emplace_back(-ahead.value, i);
    const std::size_t freedom = before.rivals[close[i]].values.size();
    const bool simpler = freedom < chosen.values.size() && ahead.value >= -std::max(ahead.standard_error, alike);
    const bool further = ahead.value > std::max(kToldApart, ahead.standard_error) &&
                         (freedom <= chosen.values.size() ||
                          (ahead.value > alike && !a_pair_does_it(task, before.rivals[close[i]], held_out)));
    if ((simpler || further) && (!result.better || ahead.value > most)) {
      result.better = close[i];
      most = ahead.value;
    }
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < std::min(kMostInseparable, order.size()); ++i)
    result.inseparable.emplace_back(close[order[i].second], std::move(fits[order[i].second]));
  return result;
}

}  // namespace lacuna
