#include "search/fitted_models.h"

#include "candidates/hypothesis.h"
#include "candidates/wrong_value.h"
#include "foundation/address.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kMostIterations = 14, kMostIterationsOnAll = 6;
constexpr std::size_t kSamplesOfDescent = 500;  ///< samples per length in a first fit
constexpr double kBetter = 1e-4;                ///< nats
constexpr double kProportion =
    1e-2;  ///< share of information by which two values must differ; with less they act as one
constexpr const char* kTiming = "timing";

/// The name of a value, prefixed with the member that it belongs to.
std::string name_of(const FreeValue& free, const std::vector<EffectEntry>& added) {
  for (const EffectEntry& entry : added)
    if (belongs_to(free, entry)) return member_name(entry) + "." + last_name(free.address);
  return free.address;
}

/// Names of a model's values in their order, with the timing's last.
std::vector<std::string> value_names(const AugmentedModel& model, bool timing) {
  std::vector<std::string> names;
  for (const FreeValue& free : model.definition.free) names.push_back(name_of(free, model.added));
  if (timing) names.emplace_back(kTiming);
  return names;
}

std::set<std::string> member_names(const std::vector<EffectEntry>& added) {
  std::set<std::string> names;
  for (const EffectEntry& entry : added) names.insert(member_name(entry));
  return names;
}

/// Whether two values change all predictions in proportion.
bool act_as_one(const Eigen::MatrixXd& information, Eigen::Index one, Eigen::Index other) {
  const double both = information(one, one) * information(other, other);
  return both > 0.0 && information(one, other) * information(one, other) > (1.0 - kProportion) * both;
}

/// Two of one effect get different ids.
std::vector<EffectEntry> with_ids(std::vector<EffectEntry> added) {
  for (std::size_t i = 0; i < added.size(); ++i) {
    added[i].id = added[i].effect;
    const auto same = std::count_if(added.begin(), added.begin() + static_cast<std::ptrdiff_t>(i),
                                    [&](const EffectEntry& other) { return other.effect == added[i].effect; });
    added[i].id += "_added" + std::to_string(same + 1);
  }
  return added;
}

}  // namespace

NamedValues named_values(const AugmentedModel& model, const std::vector<double>& values) {
  NamedValues result;
  for (std::size_t i = 0; i < model.definition.free.size(); ++i)
    result[name_of(model.definition.free[i], model.added)] = values[i];
  if (values.size() > model.definition.free.size()) result[kTiming] = values.back();
  return result;
}

std::vector<double> FittedModels::values_for(const AugmentedModel& model, const NamedValues& named) const {
  std::vector<double> values = model.definition.start_values();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto found = named.find(name_of(model.definition.free[i], model.added)); found != named.end())
      values[i] = found->second;
  if (data_.timing()) {
    const auto found = named.find(kTiming);
    values.push_back(found == named.end() ? 0.0 : found->second);
  }
  return values;
}

FittedModels::FittedModels(const SearchData& data, const PredictionLadder& ladder, KeptFits& kept)
    : data_(data), ladder_(ladder), few_(thinned(ladder, kSamplesOfDescent)), kept_(kept) {}

/// Values of an earlier search. The model as it is never starts from them: all other fits begin with its derivatives.
const KeptFit* FittedModels::known_fit(const std::vector<EffectEntry>& added) const {
  const KeptFits* known = data_.task().known;
  if (!known || added.empty()) return nullptr;
  const auto found = known->find(kept_name(added));
  const bool is_of_this_ladder = found != known->end() && found->second.starts.size() == ladder_.stretches.size();
  return is_of_this_ladder ? &found->second : nullptr;
}

/// Without a step.
const FittedModel* FittedModels::restore(const std::vector<EffectEntry>& added, const KeptFit& fit) {
  AugmentedModel model = model_with(added);
  const ModelContext context = data_.bench_for(model);
  LadderPredictions all(ladder_, context.predictor(), context.space(), data_.starts(),
                        changes_readings(model.definition));
  model.values = values_for(model, fit.values);
  const PredictionPoint point{context.space().to_coordinates(model.values), fit.starts};
  PredictionFit restored = descend(all, point, 1, plain_, value_names(model, data_.timing()));
  if (restored.valid) most_on_few_ = std::max(most_on_few_, base().fit.cost - restored.cost);
  return keep(std::move(model), std::move(restored));
}

/// The number of lengths is part of the name: values fitted to some lengths differ from those of all.
std::string FittedModels::kept_name(const std::vector<EffectEntry>& added) const {
  return fmt::format("{} lengths: {}", ladder_.lengths.size(), fmt::join(member_names(added), " + "));
}

const FittedModel* FittedModels::find(const Members& members) const {
  const auto found = models_.find(members);
  return found == models_.end() ? nullptr : &found->second;
}

AugmentedModel FittedModels::model_with(const std::vector<EffectEntry>& added) const {
  const auto holds_what_it_should = [&](const EffectEntry& entry) { return entry.fixed == held_of(entry); };
  if (const FittedModel* known = find(member_names(added));
      known && std::all_of(known->model.added.begin(), known->model.added.end(), holds_what_it_should))
    return known->model;
  std::vector<EffectEntry> entries = with_ids(added);
  for (EffectEntry& entry : entries) entry.fixed = held_of(entry);
  AugmentedModel model = with_effects(data_.plain(), entries, {}, data_.task().catalog);
  data_.bound(model);
  return model;
}

const FittedModel* FittedModels::fit(const std::vector<EffectEntry>& added, const std::vector<NamedValues>& starts,
                                     double least_share) {
  if (const KeptFit* known = known_fit(added)) return restore(added, *known);
  AugmentedModel model = model_with(added);
  if (!added.empty() && !data_.tells(static_cast<double>(model.definition.free.size()))) return nullptr;
  const ModelContext context = data_.bench_for(model);
  const bool of_readings = changes_readings(model.definition);
  const std::vector<std::string> names = value_names(model, data_.timing());
  LadderPredictions few(few_, context.predictor(), context.space(), data_.starts(), of_readings);
  const LastSteps last = added.empty() ? LastSteps::anew : LastSteps::as_it_is;
  PredictionFit least;
  for (const NamedValues& start : starts) {
    const Eigen::VectorXd values = context.space().to_coordinates(values_for(model, start));
    PredictionFit fit = descend(few, few.at_smoothed_starts(values), kMostIterations, few_plain_, names, last);
    ++fits_;
    if (fit.valid && (!least.valid || fit.cost < least.cost)) least = std::move(fit);
  }
  if (!least.valid) return find(member_names(added));
  if (added.empty()) cost_on_few_ = least.cost;
  const double gain = cost_on_few_ - least.cost;
  if (gain < least_share * most_on_few_) return find(member_names(added));
  most_on_few_ = std::max(most_on_few_, gain);
  LadderPredictions all(ladder_, context.predictor(), context.space(), data_.starts(), of_readings);
  all.take_steps_of(few);
  PredictionFit fit =
      descend(all, all.at_smoothed_starts(least.point.values), kMostIterationsOnAll, plain_, names, last);
  if (added.empty()) {
    few_plain_ = {std::move(least.by_starts), std::move(least.by_values), names};
    plain_ = {fit.by_starts, fit.by_values, names};
  }
  model.values = context.space().to_values(fit.valid ? fit.point.values : least.point.values);
  return keep(std::move(model), std::move(fit));
}

const FittedModel* FittedModels::refine(const std::vector<EffectEntry>& added, const NamedValues& start) {
  AugmentedModel model = model_with(added);
  const ModelContext context = data_.bench_for(model);
  LadderPredictions all(ladder_, context.predictor(), context.space(), data_.starts(),
                        changes_readings(model.definition));
  const Eigen::VectorXd values = context.space().to_coordinates(values_for(model, start));
  PredictionFit fit =
      descend(all, all.at_smoothed_starts(values), kMostIterationsOnAll, plain_, value_names(model, data_.timing()));
  ++fits_;
  if (fit.valid) model.values = context.space().to_values(fit.point.values);
  return keep(std::move(model), std::move(fit));
}

const FittedModel* FittedModels::keep(AugmentedModel candidate, PredictionFit fit) {
  const Members members = member_names(candidate.added);
  const FittedModel* known = find(members);
  const bool holds_more = known && candidate.definition.free.size() < known->model.definition.free.size();
  if (!fit.valid || (known && !holds_more && known->fit.cost < fit.cost + kBetter)) return known;
  FittedModel model;
  model.model = std::move(candidate);
  model.fit = std::move(fit);
  model.fit.by_starts.clear();
  model.fit.by_values.clear();
  model.values = named_values(model.model, model.model.values);
  model.judged.members = members;
  judge(model);
  kept_[kept_name(model.model.added)] = {model.values, model.fit.point.starts};
  if (data_.task().keep) data_.task().keep(kept_);
  const FittedModel& kept = models_[members] = std::move(model);
  NamedValues values = kept.values;
  if (!hold_redundant_values(kept, values)) return &kept;
  return refine(std::vector<EffectEntry>(kept.model.added), values);
}

std::vector<std::string> FittedModels::held_of(const EffectEntry& entry) const {
  const auto held = held_.find(member_name(entry));
  return held == held_.end() ? std::vector<std::string>{} : held->second;
}

/// Holds one of two values that act only together, such as area and density: the data determine their product, which
/// `values` keeps. Returns whether any fitted value was held.
bool FittedModels::hold_redundant_values(const FittedModel& single, NamedValues& values) {
  if (single.model.added.size() != 1 || held_.contains(member_name(single.model.added.front()))) return false;
  const EffectEntry& entry = single.model.added.front();
  const Eigen::MatrixXd known = information(ladder_.layout, single.fit.products,
                                            least_cost(ladder_.layout, single.fit.products, single.fit.bounds));
  std::vector<std::string>& held = held_[member_name(entry)];
  const std::vector<double> begin = single.model.definition.start_values();
  std::vector<Eigen::Index> free;
  for (std::size_t i = 0; i < single.model.definition.free.size(); ++i) {
    const std::string& address = single.model.definition.free[i].address;
    if (!is_of_effect(address, entry.id)) continue;
    const auto j = static_cast<Eigen::Index>(i);
    const bool is_factor = single.model.definition.free[i].scale == Scale::logarithmic;
    const auto as_one = std::find_if(free.begin(), free.end(), [&](Eigen::Index k) { return act_as_one(known, j, k); });
    if (!is_factor || as_one == free.end()) {
      free.push_back(j);
      continue;
    }
    held.push_back(address.substr(effect_address(entry.id, "").size()));
    const auto k = static_cast<std::size_t>(*as_one);
    double& other = values.at(name_of(single.model.definition.free[k], single.model.added));
    const double change =
        known(j, *as_one) / known(*as_one, *as_one);  // change of the other's coordinate per unit of this one
    const bool is_logarithmic = single.model.definition.free[k].scale == Scale::logarithmic;
    if (other != 0.0) other *= std::pow(single.model.values[i] / begin[i], is_logarithmic ? change : change / other);
  }
  return !held.empty();
}

void FittedModels::judge(FittedModel& model) const {
  const CellLayout& layout = ladder_.layout;
  const LinearCost least = least_cost(layout, model.fit.products, model.fit.bounds);
  model.judged.cost = cross_fit(layout, model.fit.products, model.fit.bounds, least);
  model.judged.mean_square =
      cost_at(layout, model.fit.products, Eigen::VectorXd::Zero(model.fit.products.values())).mean_square;
  const auto base = models_.find({});
  const int told = told_values(information(layout, model.fit.products, least));
  const int of_base =
      base == models_.end()
          ? told
          : told_values(information(layout, base->second.fit.products,
                                    least_cost(layout, base->second.fit.products, base->second.fit.bounds)));
  model.judged.told = std::max(static_cast<int>(model.judged.members.size()), told - of_base);
  model.judged.values =
      static_cast<int>(model.model.definition.free.size()) - static_cast<int>(data_.plain().definition.free.size());
}

}  // namespace lacuna
