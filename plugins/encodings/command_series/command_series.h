#pragma once

#include <lacuna/test_encoding.h>

namespace lacuna {

/// Commands that do not look at the sensors: a multisine, steps, a chirp or a triangle on each actuator, within its
/// limits. The genes of an actuator, a row each, are in the units of what they name, so that a genome can be said in
/// words and typed back (experiment_design/test_line.h). Their names are a promise:
///
///     motor.shape           0 multisine, 1 steps, 2 chirp, 3 triangle
///     motor.amplitude       in the command's unit; less where the limits leave less about the centre
///     motor.centre          in the command's unit
///     motor.low_frequency   Hz; steps and triangles have this one alone
///     motor.high_frequency  Hz; the two of a band may stand in either order
///     motor.seed            of the phases of a multisine and the levels of steps
///
/// The README has the equations. Commands are held from sample to sample.
class CommandSeriesEncoding : public TestEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where there is no actuator, one has no finite range, or the band of frequencies is empty or too
  /// fast for the interval between commands.
  GenomeLayout layout(const TestSpace& space, std::span<const double> parameters) const override;
  /// Frequencies are drawn on a logarithmic scale, and every second centre is the resting command.
  Genome random(const GenomeLayout& layout, RandomStream& random) const override;
  Test decode(const TestSpace& space, std::span<const double> parameters,
              std::span<const double> genome) const override;
};

}  // namespace lacuna
