#include "criterion/decision.h"

#include "criterion/evidence.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace lacuna {
namespace {

constexpr std::size_t kMostMembers = 3;
constexpr double kAsGood = 0.05;         ///< of the whole gain, that a set may be behind
constexpr double kPriceOfAValue = 0.04;  ///< of the whole gain, that a told value must earn
constexpr double kMinorError = 0.2;      ///< of the model's error: what takes less is not named beside what takes more,
constexpr double kMinorGain = 0.4;       ///< unless it makes so much of the whole gain
constexpr double kAtNoise = 1.5;         ///< mean square of whitened residuals: what leaves no more is complete
constexpr double kWorthNaming = 0.05;    ///< nats: what lowers the error by less than a twentieth is not named

/// Effects, wherever they are.
std::set<std::string> kinds_of(const CandidateSet& set) {
  std::set<std::string> kinds;
  for (const std::string& member : set.members) kinds.insert(member.substr(0, member.find(" @ ")));
  return kinds;
}

class Decider {
 public:
  Decider(const std::vector<CandidateSet>& sets, const std::vector<LookedBeside>& looked, std::uint64_t seed)
      : sets_(sets), looked_(looked), seed_(seed) {
    for (std::size_t i = 1; i < sets.size(); ++i) every_.push_back(i);
  }

  Decision decide() {
    Decision decision;
    if (every_.empty()) return decision;
    const std::size_t top = best(every_, 0);
    decision.whole_gain = gain_of(sets_[top], sets_[0]).nats;
    decision.p = probability(every_, 0);
    if (!passes(top, 0, decision.p)) return decision;
    const CandidateSet& largest = sets_[grown()];
    const int most = std::max(largest.told, static_cast<int>(largest.members.size()));
    const double gain = gain_of(largest, sets_[0]).nats;
    decision.best = best(of_at_most_told(most), 0);
    std::vector<std::size_t> alternatives = simplest_like(best_priced(most, gain), most, gain);
    decision.answer = smallest(alternatives);
    const std::size_t whole = best(alternatives, 0), main = without_minor_effects(whole, gain);
    if (main != whole) {
      decision.answer = main;
      for (const std::string& member : sets_[whole].idle)
        if (!sets_[main].members.contains(member)) decision.idle.insert(member);
      alternatives = as_good_of_as_many_values(main, gain);
    }
    for (const std::size_t i : alternatives)
      if (!holds(i, decision.answer)) decision.alike.push_back(i);
    decision.gain = gain_of(sets_[decision.answer], sets_[0]);
    return decision;
  }

 private:
  std::vector<std::size_t> of_size(std::size_t members) const {
    std::vector<std::size_t> found;
    for (const std::size_t i : every_)
      if (sets_[i].members.size() == members) found.push_back(i);
    return found;
  }

  std::vector<std::size_t> of_at_most_told(int values) const {
    std::vector<std::size_t> found;
    for (const std::size_t i : every_)
      if (sets_[i].told <= values) found.push_back(i);
    return found;
  }

  std::size_t best(const std::vector<std::size_t>& among, std::size_t over) const {
    return *std::max_element(among.begin(), among.end(), [&](std::size_t a, std::size_t b) {
      return gain_of(sets_[a], sets_[over]).nats < gain_of(sets_[b], sets_[over]).nats;
    });
  }

  double probability(const std::vector<std::size_t>& among, std::size_t over) const {
    std::vector<Eigen::VectorXd> gains;
    for (const std::size_t i : among) gains.push_back(sets_[over].cost.by_block() - sets_[i].cost.by_block());
    for (const LookedBeside& beside : looked_)
      if (beside.members == sets_[over].members) gains.insert(gains.end(), beside.gains.begin(), beside.gains.end());
    return sign_probability(gains, seed_);
  }

  bool passes(std::size_t set, std::size_t over, double p) const {
    return p < kPresent && gain_of(sets_[set], sets_[over]).is_told() &&
           gain_elsewhere(sets_[set], sets_[over]).is_told() && largest_gain(sets_[set], sets_[over]) > kWorthNaming;
  }

  /// The largest set each of whose steps in size passes, from the best single effect on.
  std::size_t grown() const {
    const std::vector<std::size_t> singles = of_size(1);
    if (singles.empty()) return best(every_, 0);
    std::size_t current = best(singles, 0);
    for (std::size_t size = 2; size <= kMostMembers; ++size) {
      const std::vector<std::size_t> sets = of_size(size);
      if (sets.empty()) break;
      const std::size_t top = best(sets, 0);
      if (passes(top, current, probability(sets, current)))
        current = top;
      else if (sets_[current].members.size() + 1 < size)
        break;
    }
    return current;
  }

  bool is_as_good(std::size_t set, std::size_t as, double whole_gain) const {
    const CostGain behind = gain_of(sets_[as], sets_[set]);
    return behind.nats <= std::max(kAsGood * whole_gain, behind.error);
  }

  bool holds(std::size_t set, std::size_t part) const {
    const std::set<std::string>&own = sets_[set].members, &of_part = sets_[part].members;
    return std::includes(own.begin(), own.end(), of_part.begin(), of_part.end());
  }

  /// The set whose gain is largest once each told value is paid for, of those of at most so many.
  std::size_t best_priced(int most_told, double whole_gain) const {
    const auto worth = [&](std::size_t i) {
      return gain_of(sets_[i], sets_[0]).nats - kPriceOfAValue * whole_gain * sets_[i].told;
    };
    std::size_t found = every_.front();
    for (const std::size_t i : every_)
      if (sets_[i].told <= most_told && (sets_[found].told > most_told || worth(i) > worth(found))) found = i;
    return found;
  }

  /// Of those of at most so many told values that gain nearly as much as one, all with the fewest that are as good as
  /// the best of them.
  std::vector<std::size_t> simplest_like(std::size_t set, int most_told, double whole_gain) const {
    std::size_t found = set;
    for (const std::size_t i : every_) {
      if (sets_[i].told > most_told || gain_of(sets_[set], sets_[i]).nats > kAsGood * whole_gain) continue;
      const bool is_better = sets_[i].told == sets_[found].told && sets_[i].cost.cost < sets_[found].cost.cost;
      if (sets_[i].told < sets_[found].told || is_better) found = i;
    }
    return as_good_of_as_many_values(found, whole_gain);
  }

  std::vector<std::size_t> as_good_of_as_many_values(std::size_t set, double whole_gain) const {
    std::vector<std::size_t> found;
    for (const std::size_t i : every_)
      if (sets_[i].told == sets_[set].told && is_as_good(i, set, whole_gain)) found.push_back(i);
    const auto all_act = [&](std::size_t i) { return sets_[i].idle.empty(); };
    if (std::any_of(found.begin(), found.end(), all_act)) std::erase_if(found, std::not_fn(all_act));
    return found;
  }

  /// Whether all that a part lacks may do nothing.
  bool lacks_idle_alone(std::size_t part, std::size_t set) const {
    const std::set<std::string>& of_part = sets_[part].members;
    return std::all_of(sets_[set].members.begin(), sets_[set].members.end(), [&](const std::string& member) {
      return of_part.contains(member) || sets_[set].idle.contains(member);
    });
  }

  /// The part of a set with the fewest told values, and of several such the best, that lacks only what may do nothing
  /// or takes little; the set itself where there is none.
  std::size_t without_minor_effects(std::size_t set, double whole_gain) const {
    std::size_t found = set;
    for (const std::size_t i : every_) {
      const bool is_part = sets_[i].members.size() < sets_[set].members.size() && holds(set, i);
      const bool lacks_little = lacks_idle_alone(i, set) && gain_of(sets_[i], sets_[0]).is_told();
      if (!is_part || !(lacks_little || is_minor(sets_[set], sets_[i], sets_[0], whole_gain))) continue;
      const bool is_better = sets_[i].cost.cost < sets_[found].cost.cost;
      if (sets_[i].told < sets_[found].told || (sets_[i].told == sets_[found].told && is_better)) found = i;
    }
    return found;
  }

  std::size_t smallest(const std::vector<std::size_t>& among) const {
    return *std::min_element(among.begin(), among.end(), [&](std::size_t a, std::size_t b) {
      if (sets_[a].values != sets_[b].values) return sets_[a].values < sets_[b].values;
      if (sets_[a].members.size() != sets_[b].members.size()) return sets_[a].members.size() < sets_[b].members.size();
      const std::size_t kinds_of_a = kinds_of(sets_[a]).size(), kinds_of_b = kinds_of(sets_[b]).size();
      if (kinds_of_a != kinds_of_b) return kinds_of_a < kinds_of_b;
      return sets_[a].cost.cost < sets_[b].cost.cost;
    });
  }

  const std::vector<CandidateSet>& sets_;
  const std::vector<LookedBeside>& looked_;
  const std::uint64_t seed_;
  std::vector<std::size_t> every_;
};

}  // namespace

CostGain gain_of(const CandidateSet& set, const CandidateSet& over) {
  const Eigen::VectorXd by_block = over.cost.by_block() - set.cost.by_block();
  return {by_block.sum(), standard_error(by_block)};
}

CostGain gain_elsewhere(const CandidateSet& set, const CandidateSet& over) {
  Eigen::MatrixXd gains = over.cost.by_length - set.cost.by_length;
  Eigen::Index most = 0;
  gains.rowwise().sum().maxCoeff(&most);
  gains.row(most).setZero();
  const Eigen::VectorXd by_block = gains.colwise().sum();
  return {by_block.sum(), standard_error(by_block)};
}

double share_of_error(const CandidateSet& set, const CandidateSet& over, const CandidateSet& model) {
  const Eigen::ArrayXd taken = (over.mean_square - set.mean_square).array().max(0.0);
  const Eigen::ArrayXd of_model = model.mean_square.array();
  return std::sqrt((of_model > 0.0).select(taken / of_model, 0.0).maxCoeff());
}

bool is_minor(const CandidateSet& set, const CandidateSet& over, const CandidateSet& model, double whole_gain) {
  const bool completes = set.mean_square.maxCoeff() < kAtNoise && over.mean_square.maxCoeff() >= kAtNoise;
  return !completes && share_of_error(set, over, model) < kMinorError &&
         gain_of(set, over).nats < kMinorGain * whole_gain;
}

double largest_gain(const CandidateSet& set, const CandidateSet& over) {
  const Eigen::VectorXd by_length = (over.cost.by_length - set.cost.by_length).rowwise().sum();
  return static_cast<double>(by_length.size()) * by_length.maxCoeff();
}

Decision decide(const std::vector<CandidateSet>& sets, const std::vector<LookedBeside>& looked, std::uint64_t seed) {
  return Decider(sets, looked, seed).decide();
}

}  // namespace lacuna
