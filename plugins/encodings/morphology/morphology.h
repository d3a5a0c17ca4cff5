#pragma once

#include <lacuna/model_encoding.h>

namespace lacuna {

/// Robots as genomes: one row of six genes a cylinder, which say what it hangs on, at which end, how long it is, where
/// it points and whether it has a touch sensor (Bongard and Lipson, experiment 2). The README has the equations.
class Morphology : public ModelEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where the robot is not made of cylinders each of which hangs on a hinge, lengths are the wrong way
  /// round, or the scale of a touch sensor is free.
  GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const override;
  ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                       std::span<const double> genome) const override;
};

}  // namespace lacuna
