#include "diagnosis/rounds/fewer_effects.h"

#include "diagnosis/rounds/channel_errors.h"
#include "diagnosis/rounds/rejudge.h"
#include "diagnosis/rounds/simpler_effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kLittle = 0.1;         ///< of the answer's gain
constexpr double kUncertain = 5.0;      ///< standard errors of what is lost: less may be a matter of form
constexpr double kHardlyLess = 0.05;    ///< of the answer's gain
constexpr double kNothingMuch = 2.0;    ///< nats
constexpr double kLargerPart = 0.5;     ///< of the squared error above the floor
constexpr double kClearOfFloor = 0.2;   ///< of the floor's square, on average
constexpr double kClearOfChance = 0.1;  ///< of the floor's square: what a channel leaves that has more than noise
constexpr double kWorthJudging = 0.3;   ///< of the best first gain: rivals with less are no answer by themselves
constexpr std::size_t kMostJudged = 6;
constexpr double kFineShare = 2e-3;  ///< of the answer's gain
constexpr int kFewSteps = 8;         ///< of a refit: what is a tenth of the gain behind shows soon

struct Judged {
  FewerEffects model;
  Eigen::VectorXd held_out;
  std::vector<ChannelError> errors;
};

class Contest {
 public:
  explicit Contest(const FewerEffectsTask& task)
      : task_(task),
        all_(task.unaided.behind),
        by_none_(errors_of(task.unaided.fit)),
        by_answer_(errors_of(task.now.fit)) {}

  std::optional<FewerEffects> run() {
    if (all_.value <= kNothingMuch) return std::nullopt;
    add_rivals();
    add_parts();
    for (std::size_t size = 1; size < task_.answer.added.size(); ++size)
      if (const Judged* best = best_of(size)) return best->model;
    judged_.clear();
    add_simpler();
    const Judged* best = best_of(task_.answer.added.size());
    return best == nullptr ? std::nullopt : std::optional(best->model);
  }

 private:
  void add_rivals() {
    const std::vector<KeptRival>& rivals = task_.first.rivals;  // the largest gain first
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < rivals.size() && all.size() < kMostJudged; ++i)
      if (rivals[i].gain.value >= kWorthJudging * rivals.front().gain.value) all.push_back(i);
    std::vector<RefitAgain> fits =
        refit_again({task_.first, task_.plain, task_.catalog, task_.now, task_.seed, task_.threads}, all);
    for (std::size_t i = 0; i < fits.size(); ++i) add({rivals[all[i]].entry}, std::move(fits[i].fit), all[i]);
  }

  /// The answer without one of its effects, without two, ...; and what was an alternative to the last of them.
  void add_parts() {
    Contender answer = task_.answer;
    answer.values = task_.now.fit.values;
    add_parts_of(answer, 0);
    for (const Contender& other : task_.alternatives)
      if (!rival_of(other.added.back())) add_last_of(other);
  }

  void add_parts_of(const Contender& whole, std::size_t from) {
    for (std::size_t i = from; whole.added.size() > 1 && i < whole.added.size(); ++i) {
      const Contender part = without(whole, i, task_.plain, task_.catalog);
      add_contender(part);
      add_parts_of(part, i);
    }
  }

  void add_last_of(Contender model) {
    while (model.added.size() > 1) model = without(model, 0, task_.plain, task_.catalog);
    add_contender(model);
  }

  void add_simpler() {
    Contender answer = task_.answer;
    answer.values = task_.now.fit.values;
    for (const Contender& model : with_simpler_effects(answer, task_.plain, task_.catalog, task_.among))
      add_contender(model);
  }

  void add_contender(const Contender& model) {
    const double precision = kFineShare * std::max(1.0, all_.value);  // of the deviance
    add(model.added, refit_under(task_.now, model, task_.threads, {precision, kFewSteps}),
        model.added.size() == 1 ? rival_of(model.added.front()) : std::nullopt);
  }

  /// The rival of the first step that is this effect.
  std::optional<std::size_t> rival_of(const EffectEntry& entry) const {
    for (std::size_t i = 0; i < task_.first.rivals.size(); ++i)
      if (name_of(task_.first.rivals[i].entry) == name_of(entry)) return i;
    return std::nullopt;
  }

  void add(std::vector<EffectEntry> added, Refit fit, std::optional<std::size_t> of_first) {
    if (!fit.valid) return;
    const Eigen::VectorXd held_out = held_out_deviance(fit, task_.now.folds);
    std::vector<ChannelError> errors = errors_of(fit);
    const Gain over_none = gain(task_.unaided.held_out, held_out, task_.seed);
    judged_.push_back({{std::move(added), std::move(fit), over_none, over_none.value / all_.value, of_first},
                       held_out,
                       std::move(errors)});
  }

  /// Of those that are enough: the best, or one with fewer parameters that is hardly behind it; nothing if none is.
  const Judged* best_of(std::size_t size) const {
    std::vector<const Judged*> enough;
    for (const Judged& one : judged_)
      if (one.model.added.size() == size && is_enough(one)) enough.push_back(&one);
    if (enough.empty()) return nullptr;
    double most = 0.0;
    for (const Judged* one : enough) most = std::max(most, one->model.gain.value);
    std::erase_if(enough, [&](const Judged* one) {
      return most - one->model.gain.value > std::max(kNothingMuch, kHardlyLess * all_.value);
    });
    return *std::min_element(enough.begin(), enough.end(), [](const Judged* one, const Judged* other) {
      return std::pair(one->model.fit.values.size(), -one->model.gain.value) <
             std::pair(other->model.fit.values.size(), -other->model.gain.value);
    });
  }

  bool is_enough(const Judged& one) const {
    const Gain lost = gain(one.held_out, task_.now.held_out, task_.seed);
    if (one.model.added.size() == task_.answer.added.size())
      return lost.value <= std::max(kNothingMuch, lost.standard_error);
    if (lost.value <= std::max(kNothingMuch, std::min(kLittle * all_.value, kUncertain * lost.standard_error)))
      return true;
    return rest_is_form(channels_of(one));
  }

  std::vector<AboveFloor> channels_of(const Judged& one) const {
    std::vector<AboveFloor> channels;
    for (std::size_t c = 0; c < one.errors.size(); ++c)
      channels.push_back({above_floor(by_none_[c]), above_floor(one.errors[c]), above_floor(by_answer_[c])});
    return channels;
  }

  std::vector<ChannelError> errors_of(const Refit& fit) const {
    return channel_errors(task_.now.base, task_.now.bins, task_.now.noise, fit, task_.now.folds);
  }

  const FewerEffectsTask& task_;
  const Gain all_;  ///< of the answer
  const std::vector<ChannelError> by_none_, by_answer_;
  std::vector<Judged> judged_;
};

}  // namespace

bool rest_is_form(const std::vector<AboveFloor>& channels) {
  double none = 0.0, fewer = 0.0;
  for (const AboveFloor& left : channels) {
    none += left.by_none;
    fewer += left.by_fewer;
    if (left.by_fewer > kClearOfChance && left.by_answer < kLargerPart * left.by_fewer) return false;
  }
  return fewer > kClearOfFloor * static_cast<double>(channels.size()) && fewer < kLargerPart * none;
}

std::optional<FewerEffects> fewer_effects(const FewerEffectsTask& task) {
  if (task.answer.added.size() < 2) return std::nullopt;
  return Contest(task).run();
}

std::string to_string(const FewerEffects& fewer, const std::vector<EffectEntry>& answer) {
  if (fewer.added.size() == answer.size())
    return fmt::format("{} gain {:.1f} % of what {} gain, with fewer parameters",
                       fmt::join(names_of(fewer.added), " and "), 100.0 * fewer.share,
                       fmt::join(names_of(answer), " and "));
  return fmt::format("{} alone gain{} {:.1f} % of what {} gain together, which more likely make up for its form",
                     fmt::join(names_of(fewer.added), " and "), fewer.added.size() == 1 ? "s" : "", 100.0 * fewer.share,
                     fmt::join(names_of(answer), " and "));
}

}  // namespace lacuna
