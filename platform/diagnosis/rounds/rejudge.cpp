#include "diagnosis/rounds/rejudge.h"

#include "diagnosis/refit/normal_equations.h"
#include "diagnosis/rounds/channel_errors.h"
#include "diagnosis/rounds/selection.h"
#include "foundation/address.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kClose = 0.5;  ///< of the chosen one's gain: less is no close call
constexpr std::size_t kMostClose = 8;
constexpr double kToldApart = 2.0;  ///< nats: less does not tell two effects apart
/// A close call is judged by deviances of this precision, of the gain and at most, and needs no more iterations.
constexpr double kFineEnough = 1e-3, kLeastFine = 2.0;
constexpr int kIterations = 8;
/// Of the gain: what two models may differ by because the noise is not quite as it is modelled.
constexpr double kAlikeShare = 0.1;
/// Of the floor's square: a model that leaves more is clear of it, one that leaves less has reached it.
constexpr double kOffFloor = 0.2, kOnFloor = 0.1;
constexpr double kWorthIt = 0.01;  ///< of the gain: squares above the floor may be those of a few readings
/// What a look-alike may be behind: odds of one to fifty, or that share of the gain, which forms differ by. The error
/// of a difference that blocks of data tell is no measure here: what one block happens to say of two models would make
/// all of them alike.
constexpr double kAlikeNats = 4.0, kInseparableShare = 0.002;
/// A value at a bound is held there by the data where a tenth of its range costs more of the deviance than that.
constexpr double kSomeWay = 0.1, kHeld = 4.0;
constexpr double kEqual = 0.5;  ///< nats: then the one with fewer parameters is named first

std::vector<std::size_t> close_calls(const SearchStep& step) {
  std::vector<std::size_t> close;
  const double least = std::max(0.0, kClose * step.rivals[step.chosen].gain.value);
  for (std::size_t i = 0; i < step.rivals.size() && close.size() < kMostClose; ++i)
    if (i != step.chosen && step.rivals[i].gain.value > least) close.push_back(i);
  return close;
}

std::vector<Contender> models_of(const RejudgeTask& task, const std::vector<std::size_t>& rivals) {
  std::vector<Contender> models;
  for (const std::size_t i : rivals) {
    std::vector<EffectEntry> added = task.before.added;
    added.push_back(task.before.rivals[i].entry);
    models.push_back(with_effects(task.plain, added, task.before.rivals[i].values, task.catalog));
  }
  return models;
}

RefitEffort effort_of(const KeptRival& rival) {
  return {std::clamp(kFineEnough * 2.0 * rival.gain.value, RefitEffort().precision, kLeastFine), kIterations};
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

double above_floor_with(const Refit& fit, const Round& now) {
  return above_floor(channel_errors(now.base, now.bins, now.noise, fit, now.folds));
}

/// Whether a richer effect leaves nothing where a simpler one leaves something, of the floor's square: that is no
/// matter of form.
bool reaches_the_floor_alone(double richer, double simpler) { return simpler > kOffFloor && richer < kOnFloor; }

/// A rival's refit against the chosen one.
struct Challenge {
  const KeptRival& rival;
  const Refit& fit;
  Eigen::VectorXd held_out;
  Gain ahead;
};

/// Than the chosen one (see `Rejudged::better`), which leaves `left` above the floor.
bool is_better(const RejudgeTask& task, const Challenge& one, double left) {
  const KeptRival& chosen = task.before.rivals[task.before.chosen];
  const double alike = std::max(kToldApart, kAlikeShare * chosen.gain.value);
  const std::size_t parameters = one.rival.values.size(), of_chosen = chosen.values.size();
  const bool ahead = one.ahead.value > std::max(kToldApart, one.ahead.standard_error);
  if (parameters <= of_chosen && ahead) return true;
  if (parameters < of_chosen)
    return one.ahead.value >= -std::max(one.ahead.standard_error, alike) &&
           !reaches_the_floor_alone(left, above_floor_with(one.fit, task.now));
  if (!ahead || parameters == of_chosen) return false;
  const bool is_sure = one.ahead.lower_95 > 0.0 && one.ahead.value > kWorthIt * chosen.gain.value;
  return (one.ahead.value > alike || (is_sure && reaches_the_floor_alone(above_floor_with(one.fit, task.now), left))) &&
         !a_pair_does_it(task, one.rival, one.held_out);
}

/// By how much the deviance grows where a value at a bound moves by `distance` into its range.
double cost_of_leaving(const Refit& fit, std::size_t value, double distance) {
  const Eigen::Index count = fit.covariance.rows(), moved = static_cast<Eigen::Index>(value);
  const NormalEquations equations = normal_equations(fit.weighted, count);
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < count; ++i)
    if (i != moved && !fit.at_bound[static_cast<std::size_t>(i)]) others.push_back(i);
  const double way = std::copysign(distance, equations.score(moved));
  return cost_of_moving(equations, {moved}, Eigen::VectorXd::Constant(1, way), others);
}

/// A value of that effect is at a bound where the data hold it.
bool is_at_limit(const ModelDefinition& definition, const EffectEntry& entry, const Refit& fit) {
  const ParameterSpace space(definition.free);
  for (std::size_t i = 0; fit.valid && i < definition.free.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    if (!fit.at_bound[i] || !is_of_effect(definition.free[i].address, entry.id)) continue;
    if (cost_of_leaving(fit, i, kSomeWay * (space.upper()(j) - space.lower()(j))) > kHeld) return true;
  }
  return false;
}

struct Alike {
  std::size_t which = 0;
  double ahead = 0.0;  ///< nats
  std::size_t parameters = 0;
};

/// The closest first, and the simplest of those that are as close.
void sort(std::vector<Alike>& alikes) {
  std::sort(alikes.begin(), alikes.end(), [](const Alike& a, const Alike& b) {
    return std::pair(-std::round(a.ahead / kEqual), a.parameters) <
           std::pair(-std::round(b.ahead / kEqual), b.parameters);
  });
}

}  // namespace

std::vector<RefitAgain> refit_again(const RejudgeTask& task, const std::vector<std::size_t>& which) {
  const std::vector<Contender> models = models_of(task, which);
  std::vector<RefitAgain> fits(which.size());
  const int inner = std::max(1, task.threads / static_cast<int>(std::max<std::size_t>(which.size(), 1)));
  parallel_for(which.size(), task.threads, [&](std::size_t i, int) {
    const KeptRival& rival = task.before.rivals[which[i]];
    fits[i].fit = refit_under(task.now, models[i], inner, effort_of(rival));
    fits[i].at_limit = is_at_limit(models[i].definition, rival.entry, fits[i].fit);
  });
  return fits;
}

Rejudged rejudge(const RejudgeTask& task) {
  const SearchStep& before = task.before;
  const KeptRival& chosen = before.rivals[before.chosen];
  const std::vector<std::size_t> close = close_calls(before);
  std::vector<RefitAgain> fits = refit_again(task, close);
  const double inseparable = std::max(kAlikeNats, kInseparableShare * chosen.gain.value);
  const double left = above_floor_with(task.now.fit, task.now);
  Rejudged result;
  double most = 0.0;
  std::vector<Alike> alikes;
  for (std::size_t i = 0; i < close.size(); ++i) {
    if (!fits[i].fit.valid) continue;
    Challenge one{before.rivals[close[i]], fits[i].fit, held_out_deviance(fits[i].fit, task.now.folds), {}};
    one.ahead = gain(task.now.held_out, one.held_out, task.seed);
    const double ahead = one.ahead.value;
    const std::size_t parameters = one.rival.values.size();
    const bool a_limit = parameters > chosen.values.size() && fits[i].at_limit && ahead < kToldApart;
    if (!a_limit && ahead > -inseparable) alikes.push_back({i, ahead, parameters});
    if (is_better(task, one, left) && (!result.better || ahead > most)) {
      result.better = close[i];
      result.values = fits[i].fit.values;
      most = ahead;
    }
  }
  sort(alikes);
  for (std::size_t i = 0; i < std::min(kMostLookAlikes, alikes.size()); ++i)
    result.inseparable.emplace_back(close[alikes[i].which], std::move(fits[alikes[i].which].fit));
  return result;
}

}  // namespace lacuna
