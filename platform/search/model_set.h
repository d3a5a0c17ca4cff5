#pragma once

#include "search/ground.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// A set's fit, and what the set costs where it was not fitted. Not valid before it is made.
struct JudgedFit {
  HorizonFit fit;
  CrossFit cross;

  bool valid() const { return fit.errors.valid; }
};

/// A set of effects beside the model, fitted to few segments (`quick`), then to all.
struct FittedSet {
  Contender model;  ///< its `added` are the set; `values` of the last fit, with the timing last where that is fitted
  HorizonFit few;
  JudgedFit all;
};

/// By name; the model as it is stands among them, its name empty.
using FittedSets = std::map<std::string, FittedSet>;

std::string name_of_set(const std::vector<EffectEntry>& added);

/// Cost of one set over another, positive where `than` costs more, with its standard error from blocks of time.
struct CostDifference {
  double nats = 0.0;
  double error = 0.0;
};

CostDifference difference(const JudgedFit& one, const JudgedFit& than);

inline constexpr int kStretches = 3;  ///< of time, of which each is left out in turn

/// Of a model's values as they are. Not valid where nothing is held out.
HorizonErrors held_out_errors(const Ground& ground, const Contender& model);

/// A fit with what the set costs where it was not fitted. Not valid where the fit is not.
JudgedFit judged(const Ground& ground, const ModelBench& bench, const Ladder& ladder, HorizonFit fit);

/// Values of a model with a set from one of which a fit begins: the best of them.
using Starts = std::vector<std::vector<double>>;

/// Fits sets and remembers them.
class ModelSets {
 public:
  explicit ModelSets(const Ground& ground);

  /// The set fitted to few segments, once from each of these; the best fit stays.
  const FittedSet& fit(const Contender& model, const std::vector<Starts>& ways);
  /// From there, on all.
  const FittedSet& finish(const std::string& name);
  /// On all from `start`, unless it is fitted to all already.
  const FittedSet& finish(const Contender& model, const std::vector<double>& start);
  const FittedSet* find(const std::string& name) const;
  const FittedSet& base() const { return *find(""); }
  const FittedSets& all() const { return sets_; }
  int refits() const { return refits_; }

 private:
  const KeptFit* known(const std::string& name) const;
  void keep(const std::string& name, const FittedSet& set);
  const FittedSet& finish(const std::string& name, const std::vector<double>& start);

  const Ground& ground_;
  FittedSets sets_;
  KeptFits kept_;
  int refits_ = 0;
};

}  // namespace lacuna
