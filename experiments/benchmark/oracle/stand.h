#pragma once

#include "oracle/nuisances.h"
#include "oracle/oracle.h"
#include "oracle/rivals.h"

#include <optional>

namespace hidden_effects {

/// A value that every model of the oracle has free: which instant a sample's command belongs to, up to one sample
/// interval either way, is no effect but a matter of recording.
inline constexpr const char* kTiming = "timing";

/// A model, its values and where the trials start; what it leaves of the truth.
struct Explanation {
  PlantModel model;
  Eigen::VectorXd values;
  std::vector<Start> starts;
  double deviance = 0.0;
};

/// The data that the oracle asks: the truth's predictions for the fit trials, and the whitening of their noise.
class TrueData {
 public:
  TrueData(const MadeCase& made, const OracleOptions& options);

  Explanation truth() const;  ///< with `kTiming` after what the owner frees
  const std::vector<FittedTrial>& trials() const { return trials_; }
  const Whiten& whiten() const { return whiten_; }
  const OracleOptions& options() const { return options_; }
  const PlantSpec& spec() const { return made_.truth.spec; }
  Scales scales(const PlacedLaw& law) const;  ///< of the truth's motion

  Question question(const Explanation& at) const;

  /// Nothing where the plant runs away.
  std::optional<Explanation> refitted(Explanation from, double settled, double hopeless) const;

 private:
  const MadeCase& made_;
  OracleOptions options_;
  std::vector<FittedTrial> trials_;
  std::vector<Motion> motions_;
  std::vector<Start> starts_;
  Whiten whiten_;
};

/// A model without the law that rivals replace, and the derivatives about it.
class Footing {
 public:
  Footing(const TrueData& data, Explanation kept, Nuisances nuisances);

  Explanation with(const PlacedLaw& rival, const std::vector<double>& parameters) const;

  /// What the rival changes, with all else that is free projected out; nothing where the plant runs away.
  std::optional<Eigen::VectorXd> effect(const PlacedLaw& rival, const std::vector<double>& parameters) const;

  const Eigen::VectorXd& lacking() const { return lacking_; }  ///< of the data, projected

 private:
  const TrueData& data_;
  Explanation kept_;
  Nuisances nuisances_;
  std::vector<Eigen::VectorXd> without_;  ///< whitened, by trial: data minus the kept model's prediction
  Eigen::VectorXd lacking_;
};

/// One law of a model taken out, all others kept, and rivals tried in its place.
class Stand {
 public:
  /// `at` explains the data; its law number `law` is taken out.
  Stand(const TrueData& data, const Explanation& at, std::size_t law);

  /// A sum of squares that is told from `reference` is not lowered with all patience, one that is not is not lowered
  /// further.
  Rival judge(const PlacedLaw& rival, double reference) const;

  /// A fit with nothing in its place; nothing where the plant runs away.
  const std::optional<Explanation>& without() const { return without_; }

  /// The best fit with a law, however slow.
  std::optional<Explanation> best(const PlacedLaw& law) const;

 private:
  struct Attempt {
    Explanation from;
    double left = 0.0;  ///< by linear estimate
  };
  struct Screened {
    std::vector<Attempt> attempts;  ///< the least left first
    double lower_estimate = 0.0;    ///< what all of them together leave
  };
  Screened screen(const PlacedLaw& rival) const;
  /// From `OracleOptions::known`: at most one a footing.
  std::vector<Attempt> known_attempts(const PlacedLaw& rival) const;
  /// Those that are worth refining.
  std::vector<Attempt> foremost(Screened screened) const;
  std::optional<Explanation> refine(const std::vector<Attempt>& attempts, double settled, double hopeless) const;

  const TrueData& data_;
  PlacedLaw taken_;
  std::vector<double> taken_parameters_;
  std::optional<Explanation> without_;
  std::vector<Footing> footings_;  ///< about the truth, and about the best fit without the law
};

}  // namespace hidden_effects
