#include "diagnosis/rejudge.h"

#include "foundation/parallel.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kClose = 0.5;  ///< of the chosen one's gain: less is no close call
constexpr std::size_t kMostClose = 4;
constexpr std::size_t kMostInseparable = 2;
constexpr double kToldApart = 2.0;  ///< nats: less does not tell two effects apart
/// Of the gain: what two models may differ by because the noise is not quite as it is modelled.
constexpr double kAlikeShare = 0.1;

std::vector<std::size_t> close_calls(const Round& round, std::size_t chosen) {
  std::vector<std::size_t> close;
  for (std::size_t i = 0; i < round.rivals.size() && close.size() < kMostClose; ++i)
    if (i != chosen && round.rivals[i].gain.value > std::max(0.0, kClose * round.rivals[chosen].gain.value))
      close.push_back(i);
  return close;
}

Refit refit_again(const Round& before, const Rival& rival, const Round& now) {
  const Hypothesis& hypothesis = before.hypotheses[rival.hypothesis];
  BaseSolution base = without_values(now.base);
  base.nuisance = rival.fit.nuisance.size() > 0 ? before.base.nuisance : std::vector<Eigen::MatrixXd>{};
  return refit({hypothesis.definition, *hypothesis.model, {}}, base, now.bins, now.factors, {rival.fit.values}, 1);
}

std::size_t freedom(const Round& round, std::size_t rival) {
  return round.hypotheses[round.rivals[rival].hypothesis].own.size();
}

}  // namespace

Rejudged rejudge(const Round& before, std::size_t chosen, const Round& now, std::uint64_t seed, int threads) {
  const std::vector<std::size_t> close = close_calls(before, chosen);
  std::vector<Refit> fits(close.size());
  parallel_for(close.size(), threads,
               [&](std::size_t i, int) { fits[i] = refit_again(before, before.rivals[close[i]], now); });
  const double alike = std::max(kToldApart, kAlikeShare * before.rivals[chosen].gain.value);
  Rejudged result;
  double most = 0.0;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < close.size(); ++i) {
    if (!fits[i].valid) continue;
    const Gain ahead = gain(now.held_out, held_out_deviance(fits[i], now.folds), seed);
    if (ahead.upper_95 >= 0.0 || ahead.value > -alike) order.emplace_back(-ahead.value, i);
    const bool simpler =
        freedom(before, close[i]) < freedom(before, chosen) && ahead.value >= -std::max(ahead.standard_error, alike);
    const bool further = ahead.value > std::max(kToldApart, ahead.standard_error) &&
                         (freedom(before, close[i]) <= freedom(before, chosen) || ahead.value > alike);
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
