#include "diagnosis/rounds/fit_rivals.h"

#include "diagnosis/rounds/search_state.h"
#include "foundation/interrupt.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <atomic>

namespace lacuna {
namespace {

constexpr std::size_t kFewestRefits = 5, kMostRefits = 10;  ///< refits
constexpr double kChance = 0.05;                            ///< beyond, the best score is no more than noise reaches
constexpr std::size_t kRefitsByChance = 2;                  ///< then, to be shown
constexpr double kComparable = 0.3;                         ///< of the best score: others as good are refitted, too
constexpr std::size_t kProbeStarts = 2;                     ///< probes that a refit starts from
constexpr std::size_t kPlaces = 4;                          ///< that as many refits start from
/// Of the deviance that a rival is worth by its score: a choice between rivals needs no finer fit, and the chosen one
/// is refitted in the next round.
constexpr double kFineEnough = 1e-3;
/// Rivals go on after so many iterations unless they are far behind the best: by that share of what it explains, and by
/// that much.
constexpr int kScoutIterations = 6;
constexpr double kFarBehind = 0.3, kFarDeviance = 20.0;

/// A hypothesis worth a refit, with the probes that it starts from.
struct Listed {
  std::size_t hypothesis = 0;
  std::vector<ProbeScore> scores;
};

std::size_t starts_of(const Hypothesis& hypothesis) { return has_place(hypothesis) ? kPlaces : kProbeStarts; }

/// The best score first.
std::vector<Listed> shortlist(const std::vector<Hypothesis>& hypotheses, const Screening& screening) {
  std::vector<Listed> list;
  const bool by_chance = screening.p > kChance;
  for (const ProbeScore& score : screening.scores) {
    const auto known =
        std::find_if(list.begin(), list.end(), [&](const Listed& one) { return one.hypothesis == score.hypothesis; });
    if (known != list.end()) {
      if (known->scores.size() < starts_of(hypotheses[score.hypothesis])) known->scores.push_back(score);
      continue;
    }
    const bool comparable = score.deviance >= kComparable * screening.scores.front().deviance;
    if (list.size() < (by_chance ? kRefitsByChance : kFewestRefits) ||
        (comparable && !by_chance && list.size() < kMostRefits))
      list.push_back({score.hypothesis, {score}});
  }
  return list;
}

/// Whether `one` is declared to look like `richer`, at the same place, and has fewer parameters.
bool is_simpler(const Hypothesis& one, const Hypothesis& richer) {
  return one.own.size() < richer.own.size() && one.where() == richer.where() &&
         std::find(richer.alike.begin(), richer.alike.end(), one.entry.effect) != richer.alike.end();
}

/// A richer law scores better by its probes than a simple one that is as good once both are refitted.
void add_simpler(const std::vector<Hypothesis>& hypotheses, const Screening& screening, std::vector<Listed>& list) {
  const std::size_t listed = list.size();
  for (const ProbeScore& score : screening.scores) {
    const auto is_it = [&](const Listed& one) { return one.hypothesis == score.hypothesis; };
    const auto richer = [&](const Listed& one) {
      return is_simpler(hypotheses[score.hypothesis], hypotheses[one.hypothesis]);
    };
    const auto known = std::find_if(list.begin(), list.end(), is_it);
    if (known != list.end()) {
      const bool is_new = static_cast<std::size_t>(known - list.begin()) >= listed;
      const bool has_room = known->scores.size() < starts_of(hypotheses[score.hypothesis]);
      if (is_new && has_room) known->scores.push_back(score);
    } else if (std::any_of(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(listed), richer)) {
      list.push_back({score.hypothesis, {score}});
    }
  }
}

/// Values to start a refit from: the probe, and the probe scaled to the size that its score wants; not where it has a
/// place, which would be scaled with it.
void add_starts(const Hypothesis& hypothesis, const Probe& probe, const ProbeScore& score,
                const std::vector<double>& base, std::vector<std::vector<double>>& starts) {
  starts.push_back(hypothesis.values(base, probe.own));
  if (has_place(hypothesis)) return;
  const double size = std::clamp(score.size, probe.one_sided ? 0.1 : -3.0, 3.0);
  std::vector<double> scaled = hypothesis.neutral;
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const FreeValue& free = hypothesis.definition.free[hypothesis.own[i]];
    if (free.scale == Scale::logarithmic)
      scaled[i] = probe.own[i];
    else
      scaled[i] = std::clamp(scaled[i] + size * (probe.own[i] - scaled[i]), free.lower, free.upper);
  }
  starts.push_back(hypothesis.values(base, scaled));
}

class RivalFits {
 public:
  RivalFits(const Round& round, const std::vector<std::vector<Probe>>& probes)
      : round_(round), probes_(probes), list_(shortlist(round.hypotheses, round.screening)) {
    add_simpler(round.hypotheses, round.screening, list_);
    rivals_.resize(list_.size());
    scouted_.resize(list_.size());
  }

  std::vector<Rival> run(std::uint64_t seed, int threads) {
    for_each_in_time(threads, [&](std::size_t i) { scout(i); });
    for (std::size_t i = 0; stopped_ && i < list_.size(); ++i)
      if (!scouted_[i]) not_examined_.push_back(name_of(round_.hypotheses[list_[i].hypothesis].entry));
    const double most = most_deviance();
    for_each_in_time(threads, [&](std::size_t i) { go_on(i, most); });
    std::erase_if(rivals_, [](const Rival& rival) { return !rival.fit.valid; });
    for (Rival& rival : rivals_) {
      rival.held_out = held_out_deviance(rival.fit, round_.folds);
      rival.gain = gain(round_.held_out, rival.held_out, seed);
    }
    std::stable_sort(rivals_.begin(), rivals_.end(),
                     [](const Rival& a, const Rival& b) { return a.gain.value > b.gain.value; });
    return std::move(rivals_);
  }

  bool stopped() const { return stopped_; }
  const std::vector<std::string>& not_examined() const { return not_examined_; }

 private:
  /// What is done when the time limit is reached stays.
  template <class Work>
  void for_each_in_time(int threads, const Work& work) {
    parallel_for(list_.size(), threads, [&](std::size_t i, int) {
      try {
        work(i);
      } catch (const TimeIsUp&) {
        stopped_ = true;
      }
    });
  }

  void scout(std::size_t i) {
    const auto& [h, scores] = list_[i];
    std::vector<std::vector<double>> starts;
    for (const ProbeScore& score : scores)
      add_starts(round_.hypotheses[h], probes_[h][score.probe], score, round_.base.values, starts);
    rivals_[i].hypothesis = h;
    rivals_[i].deviance = scores.front().deviance;
    rivals_[i].fit =
        has_place(round_.hypotheses[h]) ? best_fit(i, starts) : fit(i, starts, round_.base, kScoutIterations);
    scouted_[i] = 1;
  }

  /// From each start: places have minima of their own, and the cost at a start does not tell which is the deepest.
  Refit best_fit(std::size_t i, const std::vector<std::vector<double>>& starts) const {
    Refit best;
    for (const std::vector<double>& start : starts) {
      Refit one = fit(i, {start}, round_.base, kScoutIterations);
      if (one.valid && (!best.valid || one.deviance < best.deviance)) best = std::move(one);
    }
    return best;
  }

  /// Beyond which a scout goes no further.
  double most_deviance() const {
    double best = round_.fit.deviance;
    for (const Rival& rival : rivals_)
      if (rival.fit.valid) best = std::min(best, rival.fit.deviance);
    return best + std::max(kFarDeviance, kFarBehind * (round_.fit.deviance - best));
  }

  void go_on(std::size_t i, double most) {
    const Refit& scout = rivals_[i].fit;
    if (!scout.valid || scout.converged || scout.deviance > most) return;
    Refit further = fit(i, {scout.values}, from(round_.base, scout), RefitEffort().iterations);
    if (further.valid && further.deviance <= scout.deviance + RefitEffort().precision)
      rivals_[i].fit = std::move(further);
  }

  Refit fit(std::size_t i, const std::vector<std::vector<double>>& starts, const BaseSolution& base,
            int iterations) const {
    const auto& [h, scores] = list_[i];
    const Hypothesis& hypothesis = round_.hypotheses[h];
    return refit({hypothesis.definition, *hypothesis.model, hypothesis.base}, base, round_.bins, round_.factors, starts,
                 1, {std::max(RefitEffort().precision, kFineEnough * scores.front().deviance), iterations});
  }

  const Round& round_;
  const std::vector<std::vector<Probe>>& probes_;
  std::vector<Listed> list_;
  std::vector<Rival> rivals_;
  std::vector<char> scouted_;  ///< no bits: threads write side by side
  std::atomic<bool> stopped_ = false;
  std::vector<std::string> not_examined_;
};

}  // namespace

void fit_rivals(Round& round, const std::vector<std::vector<Probe>>& probes, std::uint64_t seed, int threads) {
  RivalFits fits(round, probes);
  round.rivals = fits.run(seed, threads);
  round.stopped = fits.stopped();
  round.not_examined = fits.not_examined();
}

}  // namespace lacuna
