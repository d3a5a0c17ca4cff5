#include "answer/evidence.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr double kMostSure = 10.0;  ///< standard errors; a larger lead makes a verdict no surer
constexpr double kSmallest = 1e-3;  ///< nats

double sureness(const CostGain& gain) {
  if (!(gain.error > 0.0)) return gain.nats > 0.0 ? kMostSure : 0.0;
  return std::clamp(gain.nats / gain.error, -kMostSure, kMostSure);
}

const FittedModel& answer_of(const SearchResult& found) { return found.sets[found.decision.answer]; }

bool has_all_of(const FittedModel& set, const FittedModel& part) {
  const std::set<std::string>&own = set.judged.members, &of_part = part.judged.members;
  return std::includes(own.begin(), own.end(), of_part.begin(), of_part.end());
}

/// Whether a set contains the answer or a set that is indistinguishable from it.
bool says_the_same(const SearchResult& found, const FittedModel& set) {
  const std::vector<std::size_t>& alike = found.decision.alike;
  return has_all_of(set, answer_of(found)) ||
         std::any_of(alike.begin(), alike.end(), [&](std::size_t i) { return has_all_of(set, found.sets[i]); });
}

/// The share of lengths and folds (recordings, or thirds of time) in which the answer lowers the cost.
double share_of_help(const SearchResult& found) {
  const Eigen::MatrixXd gains = found.sets.front().judged.cost.by_length - answer_of(found).judged.cost.by_length;
  Eigen::MatrixXd by_fold = Eigen::MatrixXd::Zero(gains.rows(), static_cast<Eigen::Index>(found.layout.folds));
  for (Eigen::Index block = 0; block < gains.cols(); ++block)
    by_fold.col(static_cast<Eigen::Index>(found.layout.fold_of_block[static_cast<std::size_t>(block)])) +=
        gains.col(block);
  return static_cast<double>((by_fold.array() > 0.0).count()) / static_cast<double>(by_fold.size());
}

/// The smallest contribution of one of the answer's effects, as a share of the gain of all of them.
double least_part(const SearchResult& found) {
  const FittedModel& answer = answer_of(found);
  double least = 1.0;
  for (const FittedModel& part : found.sets)
    if (part.judged.members.size() + 1 == answer.judged.members.size() && has_all_of(answer, part))
      least = std::min(least, gain_of(answer.judged, part.judged).nats / found.decision.gain.nats);
  return std::clamp(least, 0.0, 1.0);
}

}  // namespace

std::vector<std::string> look_alikes_of(const SearchResult& found) {
  std::set<std::string> names;
  for (const std::size_t i : found.decision.alike)
    for (const std::string& name : found.sets[i].judged.members)
      if (!answer_of(found).judged.members.contains(name)) names.insert(name);
  return {names.begin(), names.end()};
}

OtherSet nearest_other(const SearchResult& found) {
  OtherSet nearest{nullptr, kMostSure};
  for (const FittedModel& set : found.sets) {
    if (says_the_same(found, set)) continue;
    const double lead = sureness(gain_of(answer_of(found).judged, set.judged));
    if (!nearest.set || lead < nearest.lead) nearest = {&set, lead};
  }
  return nearest;
}

Evidence evidence_of(const SearchResult& found) {
  const FittedModel& answer = answer_of(found);
  const double before = found.sets.front().judged.cost.cost, after = answer.judged.cost.cost;
  Evidence evidence = {{"surprise", -std::log10(found.decision.p)},
                       {"base_cost", before},
                       {"nested_sets", found.nested},
                       {"unnested_sets", found.unnested},
                       {"log_readings", std::log10(std::max(1.0, found.data->readings()))}};
  if (found.decision.answer == 0) return evidence;
  evidence["log_gain"] = std::log10(std::max(kSmallest, found.decision.gain.nats));
  evidence["sureness"] = sureness(found.decision.gain);
  evidence["lead"] = nearest_other(found).lead;
  evidence["help"] = share_of_help(found);
  evidence["least_part"] = least_part(found);
  evidence["left"] = before > 0.0 ? std::clamp(after / before, 0.0, 1.0) : 0.0;
  evidence["share"] = found.decision.gain.nats / std::max(kSmallest, found.decision.whole_gain);
  evidence["further_effects"] = static_cast<double>(answer.judged.members.size()) - 1.0;
  evidence["look_alikes"] = static_cast<double>(look_alikes_of(found).size());
  evidence["all_lengths"] = found.by_all_lengths ? 1.0 : 0.0;
  return evidence;
}

}  // namespace lacuna
