#include "search/model_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace lacuna {
namespace {

constexpr double kFewestBlocks = 6.0;  ///< by which an error is estimated

}  // namespace

std::string name_of_set(const std::vector<EffectEntry>& added) {
  std::set<std::string> names;
  for (const EffectEntry& entry : added)
    names.insert(entry.effect + " @ " + (entry.where.empty() ? "world" : entry.where.front()));
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " + ") + name;
  return text;
}

ModelSets::ModelSets(const Ground& ground) : ground_(ground) {
  if (ground.task().known) kept_ = *ground.task().known;
  const Contender& plain = ground.plain();
  const ModelBench bench = ground_.bench_for(plain);
  const Ladder ladder = ground.ladder_for(bench), few = quick(ladder);
  sets_[""] = {plain, fit_to_ladder(few, bench.predictor(), bench.space(), plain.values, Climb::whole),
               judged(ground, bench, ladder, ground.fit())};
}

JudgedFit judged(const Ground& ground, const ModelBench& bench, const Ladder& ladder, HorizonFit fit) {
  if (!fit.errors.valid) return {};
  CrossFit cross = linearise(ladder, bench.predictor(), bench.space(), fit, ground.block()).cross_fit(kStretches);
  return {std::move(fit), std::move(cross)};
}

const FittedSet* ModelSets::find(const std::string& name) const {
  const auto found = sets_.find(name);
  return found == sets_.end() ? nullptr : &found->second;
}

const KeptFit* ModelSets::known(const std::string& name) const {
  const KeptFits* known = ground_.task().known;
  if (!known) return nullptr;
  const auto found = known->find(name);
  return found == known->end() ? nullptr : &found->second;
}

void ModelSets::keep(const std::string& name, const FittedSet& set) {
  if (!ground_.task().keep) return;
  KeptFit& kept = kept_[name];
  if (set.few.errors.valid) kept.rough = set.few.values;
  if (set.all.valid()) kept.values = set.all.fit.values, kept.states = set.all.fit.states;
  ground_.task().keep(kept_);
}

namespace {

HorizonFit fit_from(const Starts& starts, const Ladder& ladder, const ModelBench& bench) {
  const std::vector<double>* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& start : starts)
    if (const HorizonErrors errors = errors_on(ladder, bench.predictor(), bench.space(), start);
        errors.valid && errors.cost < least)
      least = errors.cost, best = &start;
  if (!best) return {};
  return fit_to_ladder(ladder, bench.predictor(), bench.space(), *best, Climb::from_the_bottom);
}

HorizonFit best_fit(const std::vector<Starts>& ways, const Ladder& ladder, const ModelBench& bench) {
  HorizonFit best;
  for (const Starts& starts : ways) {
    HorizonFit found = fit_from(starts, ladder, bench);
    if (found.errors.valid && (!best.errors.valid || found.errors.cost < best.errors.cost)) best = std::move(found);
  }
  return best;
}

}  // namespace

const FittedSet& ModelSets::fit(const Contender& model, const std::vector<Starts>& ways) {
  FittedSet set{model, {}, {}};
  const ModelBench bench = ground_.bench_for(set.model);
  const Ladder few = quick(ground_.ladder_for(bench));
  const std::string name = name_of_set(model.added);
  if (const KeptFit* fit = known(name)) {
    if (!fit->rough.empty()) set.few = fit_at(few, bench.predictor(), bench.space(), fit->rough);
  } else {
    refits_ += static_cast<int>(ways.size());
    set.few = best_fit(ways, few, bench);
  }
  if (set.few.errors.valid) set.model.values = set.few.values;
  FittedSet& kept = sets_[name] = std::move(set);
  keep(name, kept);
  return kept;
}

const FittedSet& ModelSets::finish(const std::string& name) { return finish(name, find(name)->few.values); }

const FittedSet& ModelSets::finish(const Contender& model, const std::vector<double>& start) {
  const std::string name = name_of_set(model.added);
  if (!find(name)) {
    FittedSet& set = sets_[name] = {model, {}, {}};
    const ModelBench bench = ground_.bench_for(set.model);
    set.few = fit_at(quick(ground_.ladder_for(bench)), bench.predictor(), bench.space(), start);
  }
  return finish(name, start);
}

const FittedSet& ModelSets::finish(const std::string& name, const std::vector<double>& start) {
  FittedSet& set = sets_.at(name);
  if (set.all.valid() || !set.few.errors.valid) return set;
  const ModelBench bench = ground_.bench_for(set.model);
  const Ladder ladder = ground_.ladder_for(bench);
  const KeptFit* fit = known(name);
  const bool is_kept = fit && !fit->values.empty();
  refits_ += is_kept ? 0 : 1;
  set.all = judged(ground_, bench, ladder,
                   is_kept ? fit_at(ladder, bench.predictor(), bench.space(), fit->values, fit->states)
                           : fit_to_ladder(ladder, bench.predictor(), bench.space(), start, Climb::whole));
  if (!set.all.valid()) return set;
  set.model.values = set.all.fit.values;
  keep(name, set);
  return set;
}

HorizonErrors held_out_errors(const Ground& ground, const Contender& model) {
  const ModelBench bench = ground.bench_for(model);
  return errors_on(ground.ladder_for(bench, true), bench.predictor(), bench.space(), model.values);
}

CostDifference difference(const JudgedFit& one, const JudgedFit& than) {
  const Eigen::VectorXd by_block = than.cross.by_block - one.cross.by_block;
  CostDifference result{than.cross.cost - one.cross.cost, 0.0};
  // Neighbouring blocks may err together: the largest error of blocks once, twice and four times as long.
  for (const Eigen::Index together : {1, 2, 4}) {
    double squares = 0.0, count = 0.0;
    for (Eigen::Index b = 0; b < by_block.size(); b += together, count += 1.0)
      squares += std::pow(by_block.segment(b, std::min(together, by_block.size() - b)).sum(), 2);
    if (count < kFewestBlocks && together > 1) continue;
    // Of n blocks the standard deviation of Student's t with n − 1 degrees of freedom.
    const double few = std::sqrt(std::max(1.0, count - 1.0) / std::max(0.5, count - 3.0));
    result.error = std::max(result.error, few * std::sqrt(squares * count / std::max(1.0, count - 1.0)));
  }
  return result;
}

}  // namespace lacuna
