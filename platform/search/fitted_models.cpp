#include "search/fitted_models.h"

#include "candidates/hypothesis.h"
#include "candidates/wrong_value.h"
#include "foundation/address.h"
#include "prediction/whitened_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr int kMostIterations = 14, kMostIterationsOnAll = 6;
constexpr std::size_t kSamplesOfDescent = 500;  ///< samples per length in a first fit
constexpr double kBetter = 1e-4;                ///< nats
constexpr double kProportion =
    1e-2;  ///< share of information by which two values must differ; with less they act as one
constexpr const char* kTiming = "timing";

/// The name of a value, prefixed with the member that it belongs to.
std::string name_of(const FreeValue& free, const std::vector<EffectEntry>& placed) {
  for (const EffectEntry& entry : placed)
    if (belongs_to(free, entry)) return member_name(entry) + "." + last_name(free.address);
  return free.address;
}

/// Names of a model's values in their order, with the timing's last.
std::vector<std::string> value_names(const AugmentedModel& model, bool timing) {
  std::vector<std::string> names;
  for (const FreeValue& free : model.definition.free) names.push_back(name_of(free, model.placed));
  if (timing) names.emplace_back(kTiming);
  return names;
}

/// Whether two values change all predictions in proportion.
bool act_as_one(const Eigen::MatrixXd& information, Eigen::Index one, Eigen::Index other) {
  const double both = information(one, one) * information(other, other);
  return both > 0.0 && information(one, other) * information(one, other) > (1.0 - kProportion) * both;
}

/// Values of effects with a value for each joint beyond those at the first joint: to the decision, friction in six
/// joints is one law.
int repeated_values(const AugmentedModel& model) {
  int repeated = 0;
  for (const EffectEntry& entry : model.added) {
    const std::vector<EffectEntry> placed = placed_entries(entry, model.definition.structure.robot);
    for (std::size_t i = 1; i < placed.size(); ++i)
      for (const FreeValue& free : model.definition.free) repeated += belongs_to(free, placed[i]) ? 1 : 0;
  }
  return repeated;
}

/// A value of an effect that acts only together with another one of it.
struct RedundantValue {
  std::size_t value = 0, as = 0;  ///< of the free values
  double change = 0.0;            ///< of the other's coordinate per unit of this one
};

std::vector<RedundantValue> redundant_values(const std::vector<FreeValue>& free, const EffectEntry& placed,
                                             const Eigen::MatrixXd& known) {
  std::vector<RedundantValue> redundant;
  std::vector<Eigen::Index> others;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (!is_of_effect(free[i].address, placed.id)) continue;
    const auto j = static_cast<Eigen::Index>(i);
    const auto as = std::find_if(others.begin(), others.end(), [&](Eigen::Index k) { return act_as_one(known, j, k); });
    if (free[i].scale == Scale::logarithmic && as != others.end())
      redundant.push_back({i, static_cast<std::size_t>(*as), known(j, *as) / known(*as, *as)});
    else
      others.push_back(j);
  }
  return redundant;
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

std::set<std::string> members_of(const std::vector<EffectEntry>& added) {
  std::set<std::string> names;
  for (const EffectEntry& entry : added) names.insert(member_name(entry));
  return names;
}

NamedValues named_values(const AugmentedModel& model, const std::vector<double>& values) {
  NamedValues result;
  for (std::size_t i = 0; i < model.definition.free.size(); ++i)
    result[name_of(model.definition.free[i], model.placed)] = values[i];
  if (values.size() > model.definition.free.size()) result[kTiming] = values.back();
  return result;
}

std::vector<double> FittedModels::values_for(const AugmentedModel& model, const NamedValues& named) const {
  std::vector<double> values = model.definition.start_values();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto found = named.find(name_of(model.definition.free[i], model.placed)); found != named.end())
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
  return fmt::format("{} lengths: {}", ladder_.lengths.size(), fmt::join(members_of(added), " + "));
}

const FittedModel* FittedModels::find(const Members& members) const {
  const auto found = models_.find(members);
  return found == models_.end() ? nullptr : &found->second;
}

AugmentedModel FittedModels::model_with(const std::vector<EffectEntry>& added) const {
  const auto holds_what_it_should = [&](const EffectEntry& entry) { return entry.fixed == held_of(entry); };
  if (const FittedModel* known = find(members_of(added));
      known && std::all_of(known->model.added.begin(), known->model.added.end(), holds_what_it_should))
    return known->model;
  std::vector<EffectEntry> entries = with_ids(added);
  for (EffectEntry& entry : entries) entry.fixed = held_of(entry);
  AugmentedModel model = with_effects(data_.plain(), entries, {}, data_.task().catalog);
  data_.bound(model);
  return model;
}

/// On a few stretches from their smoothed starts; infinite where a stretch cannot be simulated.
double FittedModels::cost_at_start(LadderPredictions& few, const Eigen::VectorXd& values) const {
  std::vector<LinearStretch> stretches(few.ladder().stretches.size());
  for (std::size_t k = 0; k < stretches.size(); ++k) stretches[k].start = few_plain_.by_starts[k];
  if (!few.residuals_at(few.at_smoothed_starts(values), stretches)) return std::numeric_limits<double>::infinity();
  const BlockProducts products = whitened_products(few.ladder(), stretches);
  return cost_at(few.ladder().layout, products, Eigen::VectorXd::Zero(products.values())).cost;
}

/// Coordinates of values from which to descend.
std::vector<Eigen::VectorXd> FittedModels::places_to_begin(const AugmentedModel& model, const ModelContext& context,
                                                           LadderPredictions& few,
                                                           const std::vector<NamedValues>& starts,
                                                           const std::vector<NamedValues>& slight) const {
  std::vector<Eigen::VectorXd> places;
  for (const NamedValues& start : starts) places.push_back(context.space().to_coordinates(values_for(model, start)));
  if (model.added.empty() || data_.acceleration_steps().empty() || model.model->has_memory() ||
      changes_readings(model.definition))
    return places;
  const AccelerationSteps& given = data_.acceleration_steps();
  const std::unique_ptr<CompiledModel> fine = compile(model.definition.structure, given.engine);
  const ModelContext of_steps(model.definition, *fine, given.trials, data_.timing(), data_.task().work,
                              kCommandsMayAct);
  LadderPredictions steps(given.ladder, of_steps.predictor(), of_steps.space(), data_.starts());
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& place : places) least = std::min(least, cost_at_start(few, place));
  for (const NamedValues& start : slight) {
    const Eigen::VectorXd values = context.space().to_coordinates(values_for(model, start));
    PredictionFit fit = descend(steps, steps.at_smoothed_starts(values), kMostIterations);
    if (!fit.valid) continue;
    const double cost = cost_at_start(few, fit.point.values);
    if (!(cost < least)) continue;
    least = cost;
    places = {std::move(fit.point.values)};
  }
  return places;
}

const FittedModel* FittedModels::fit(const std::vector<EffectEntry>& added, const std::vector<NamedValues>& starts,
                                     const std::vector<NamedValues>& slight, double least_share) {
  if (const KeptFit* known = known_fit(added)) return restore(added, *known);
  AugmentedModel model = model_with(added);
  if (!added.empty() && !data_.tells(static_cast<double>(model.definition.free.size()))) return nullptr;
  const ModelContext context = data_.bench_for(model);
  const bool of_readings = changes_readings(model.definition);
  const std::vector<std::string> names = value_names(model, data_.timing());
  LadderPredictions few(few_, context.predictor(), context.space(), data_.starts(), of_readings);
  const LastSteps last = added.empty() ? LastSteps::anew : LastSteps::as_it_is;
  PredictionFit least;
  for (const Eigen::VectorXd& values : places_to_begin(model, context, few, starts, slight)) {
    PredictionFit fit = descend(few, few.at_smoothed_starts(values), kMostIterations, few_plain_, names, last);
    ++fits_;
    if (fit.valid && (!least.valid || fit.cost < least.cost)) least = std::move(fit);
  }
  if (!least.valid) return find(members_of(added));
  if (added.empty()) cost_on_few_ = least.cost;
  const double gain = cost_on_few_ - least.cost;
  if (gain < least_share * most_on_few_) return find(members_of(added));
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
  const Members members = members_of(candidate.added);
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
  const Eigen::MatrixXd known = information(ladder_.layout, single.fit.products,
                                            least_cost(ladder_.layout, single.fit.products, single.fit.bounds));
  const std::vector<FreeValue>& free = single.model.definition.free;
  std::vector<RedundantValue> redundant;
  for (const EffectEntry& placed : single.model.placed)
    for (const RedundantValue& one : redundant_values(free, placed, known)) redundant.push_back(one);
  const auto at_every_place = [&](const std::string& name) {
    const auto is_it = [&](const RedundantValue& one) { return last_name(free[one.value].address) == name; };
    return std::count_if(redundant.begin(), redundant.end(), is_it) == std::ssize(single.model.placed);
  };
  std::vector<std::string>& held = held_[member_name(single.model.added.front())];
  for (const RedundantValue& one : redundant) {
    const std::string name = last_name(free[one.value].address);
    if (!at_every_place(name)) continue;
    if (std::count(held.begin(), held.end(), name) == 0) held.push_back(name);
    double& other = values.at(name_of(free[one.as], single.model.placed));
    const bool is_logarithmic = free[one.as].scale == Scale::logarithmic;
    if (other != 0.0)
      other *= std::pow(single.model.values[one.value] / free[one.value].start,
                        is_logarithmic ? one.change : one.change / other);
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
  const int repeated = repeated_values(model.model);
  model.judged.told = std::max(static_cast<int>(model.judged.members.size()), told - of_base - repeated);
  model.judged.values = static_cast<int>(model.model.definition.free.size()) -
                        static_cast<int>(data_.plain().definition.free.size()) - repeated;
}

}  // namespace lacuna
