#pragma once

#include "baselines/recorded_motion.h"

namespace hidden_effects {

/// A law's parameters to begin with, and what `at_size` made them of.
struct Try {
  double size = 1.0;
  Shape shape{};
  std::vector<double> parameters;
};

/// An effect of the library at a place of the rig: what all baselines choose from.
struct Candidate {
  PlacedLaw law;
  Scales scales;

  /// All different: sizes and shapes spread evenly, `count` of them or fewer.
  std::vector<Try> tries(std::size_t count) const;
  std::vector<double> at_size(double size, const Shape& shape) const { return law.kind->at_size(size, scales, shape); }
};

/// Every law in the library's form that applies somewhere, at each such place, without those that are withheld.
std::vector<Candidate> all_candidates(const Observed& seen, const RecordedMotions& motions);

/// The base with a law, and the base's values with its parameters behind.
PlantModel with_law(const PlantModel& base, const PlacedLaw& law);
Eigen::VectorXd with_parameters(const Eigen::VectorXd& values, const std::vector<double>& parameters);

}  // namespace hidden_effects
