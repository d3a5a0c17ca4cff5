#pragma once

#include <lacuna/test_encoding.h>

namespace lacuna {

/// The seed's controllers (Bongard and Lipson, experiment 1): sensors, one layer of hidden neurons that also see each
/// other's last activation, and actuators; a bias to hidden and output neurons. The genes are the weights, neuron after
/// neuron: S + H + 1 for each hidden one, H + 1 for each actuator; 68 for 8, 3 and 8. The README has the equations.
/// Commands lie within the space's bounds. A controller's state is the hidden activations, 0 at the start.
class RecurrentNetwork : public TestEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where there is no actuator, one has no finite range, or a channel has a neuron's name.
  GenomeLayout layout(const TestSpace& space, std::span<const double> parameters) const override;
  Test decode(const TestSpace& space, std::span<const double> parameters,
              std::span<const double> genome) const override;
};

}  // namespace lacuna
