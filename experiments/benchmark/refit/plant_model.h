#pragma once

#include "laws/law_kind.h"
#include "plant/motion.h"
#include "rigs/rig.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace hidden_effects {

/// A law at an element of a plant, or at all of them.
struct PlacedLaw {
  const LawKind* kind = nullptr;
  int element = 0;  ///< or `kEverywhere`
  bool operator==(const PlacedLaw&) const = default;
};

/// What is believed of a rig: which values are free, which laws act. Its values, in this order: the free values of the
/// rig, then the parameters of each law.
struct PlantModel {
  PlantSpec spec;  ///< with the values that nobody frees
  std::vector<FreeValue> free;
  std::vector<PlacedLaw> laws;

  std::size_t size() const;
  PlantSpec spec_at(const Eigen::VectorXd& values) const;
  Laws laws_at(const Eigen::VectorXd& values) const;
};

/// Readings by sensor, one a sample.
using Readings = std::vector<std::vector<double>>;

/// A trial as somebody who fits a model has it.
struct FittedTrial {
  Excitation excitation;  ///< as recorded: no random forces
  Readings readings;
};

/// One integration step for all fits, s: its error is far below any noise here, and the same on both sides.
inline constexpr double kFitStep = 2.5e-4;

/// What a model predicts, integrated by `step`; throws as `simulate` does.
Readings predict(const PlantModel& model, const Eigen::VectorXd& values, const Excitation& excitation,
                 const Start& start, double step = kFitStep);

}  // namespace hidden_effects
