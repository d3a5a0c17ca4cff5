#pragma once

#include "criterion/decision.h"
#include "search/search_data.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// A model's values in the order of its free values, the timestamp offset last where it is fitted.
NamedValues named_values(const AugmentedModel& model, const std::vector<double>& values);

/// A set of effects beside the model, fitted.
struct FittedModel {
  AugmentedModel model;  ///< its `added` are the set
  PredictionFit fit;
  NamedValues values;
  CandidateSet judged;
};

/// "effect @ place" of each.
std::set<std::string> members_of(const std::vector<EffectEntry>& added);

/// Fits sets of effects on one ladder and keeps the fits by their members.
class FittedModels {
 public:
  /// `kept`: receives the fits; must outlive this.
  FittedModels(const SearchData& data, const PredictionLadder& ladder, KeptFits& kept);

  using Members = std::set<std::string>;

  /// Fits the set from each of these starts on a few stretches, continues from the best on all, and keeps the cheapest,
  /// also compared with an earlier fit of the set. Values that a start does not name come from the file. Nothing where
  /// the set cannot be simulated, or gains less than `least_share` of the best set's gain on the few stretches.
  /// `slight`: values at which one effect of the set hardly acts. From there the set is first fitted to acceleration
  /// steps (prediction/acceleration_steps.h); where that leads to a lower cost than every start, it is the start.
  const FittedModel* fit(const std::vector<EffectEntry>& added, const std::vector<NamedValues>& starts,
                         const std::vector<NamedValues>& slight = {}, double least_share = 0.0);
  /// Continues from this start on all stretches.
  const FittedModel* refine(const std::vector<EffectEntry>& added, const NamedValues& start);
  const FittedModel* find(const Members& members) const;
  const FittedModel& base() const { return models_.at({}); }
  const std::map<Members, FittedModel>& all() const { return models_; }
  const PredictionLadder& ladder() const { return ladder_; }
  int fits() const { return fits_; }

 private:
  std::vector<Eigen::VectorXd> places_to_begin(const AugmentedModel& model, const ModelContext& context,
                                               LadderPredictions& few, const std::vector<NamedValues>& starts,
                                               const std::vector<NamedValues>& slight) const;
  double cost_at_start(LadderPredictions& few, const Eigen::VectorXd& values) const;
  std::vector<double> values_for(const AugmentedModel& model, const NamedValues& named) const;
  AugmentedModel model_with(const std::vector<EffectEntry>& added) const;
  const KeptFit* known_fit(const std::vector<EffectEntry>& added) const;
  const FittedModel* restore(const std::vector<EffectEntry>& added, const KeptFit& fit);
  std::string kept_name(const std::vector<EffectEntry>& added) const;
  const FittedModel* keep(AugmentedModel candidate, PredictionFit fit);
  void judge(FittedModel& model) const;
  bool hold_redundant_values(const FittedModel& single, NamedValues& values);
  std::vector<std::string> held_of(const EffectEntry& entry) const;

  const SearchData& data_;
  const PredictionLadder& ladder_;
  const PredictionLadder few_;
  KeptFits& kept_;
  std::map<Members, FittedModel> models_;
  std::map<std::string, std::vector<std::string>>
      held_;                     ///< by member: values that act only together with another of its values
  LikeModel plain_, few_plain_;  ///< derivatives of the model as it is
  double cost_on_few_ = 0.0;     ///< nats, of the model as it is
  double most_on_few_ = 0.0;     ///< nats, the most that a set gained
  int fits_ = 0;
};

}  // namespace lacuna
