#pragma once

#include "oracle/nuisances.h"
#include "oracle/oracle.h"
#include "oracle/rivals.h"

#include <memory>
#include <optional>

namespace hidden_effects {

/// A model, its values and where the trials start; what it leaves of the truth.
struct Candidate {
  PlantModel model;
  Eigen::VectorXd values;
  std::vector<Start> starts;
  double deviance = 0.0;
};

/// The data that the oracle asks: the truth's predictions for the fit trials, and the whitening of their noise.
class TrueData {
 public:
  TrueData(const MadeCase& made, const OracleOptions& options);

  Candidate truth() const;
  const std::vector<FittedTrial>& trials() const { return trials_; }
  const Whiten& whiten() const { return whiten_; }
  const OracleOptions& options() const { return options_; }
  Scales scales(const PlacedLaw& law) const;  ///< of the truth's motion

  Question question(const Candidate& at) const;

  /// Nothing where the plant runs away.
  std::optional<Candidate> refitted(Candidate from, double settled) const;

 private:
  const MadeCase& made_;
  OracleOptions options_;
  std::vector<FittedTrial> trials_;
  std::vector<Motion> motions_;
  std::vector<Start> starts_;
  Whiten whiten_;
};

/// One law of a model taken out, all others kept, and rivals tried in its place.
class Stand {
 public:
  /// `at` explains the data; its law number `law` is taken out.
  Stand(const TrueData& data, const Candidate& at, std::size_t law);

  /// A sum of squares below `settled` is not lowered further.
  Rival judge(const PlacedLaw& rival, double settled);

  /// The best fit with the rival; nothing where none was found.
  const std::optional<Candidate>& best() const { return best_; }

 private:
  struct Attempt {
    std::vector<double> parameters;
    double left = 0.0;
  };
  struct Screened {
    std::vector<Attempt> attempts;  ///< the least left first
    double lower_estimate = 0.0;    ///< what all of them together leave
  };
  Screened screen(const PlacedLaw& rival) const;
  std::optional<Eigen::VectorXd> effect(const PlacedLaw& rival, const std::vector<double>& parameters) const;
  void search_size(const PlacedLaw& rival, const Scales& scales, const Shape& shape, std::vector<Attempt>& attempts,
                   std::vector<Eigen::VectorXd>& effects) const;
  Candidate with(const PlacedLaw& rival, const std::vector<double>& parameters) const;

  const TrueData& data_;
  Candidate kept_;
  std::unique_ptr<Nuisances> nuisances_;
  std::vector<Eigen::VectorXd> without_;  ///< whitened, by trial: data minus the kept laws' prediction
  Eigen::VectorXd lacking_;               ///< the same, projected
  std::optional<Candidate> best_;
};

}  // namespace hidden_effects
