#pragma once

#include <lacuna/genome.h>
#include <lacuna/parameter.h>
#include <lacuna/random_stream.h>
#include <lacuna/test.h>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The channels and commands that a test can use.
struct TestSpace {
  std::vector<Channel> sensors;    ///< in the robot's order
  std::vector<Channel> actuators;  ///< in the robot's order; commands in these units
  std::vector<double> lower;       ///< smallest command, one per actuator
  std::vector<double> upper;       ///< largest command
  double control_period = 0.0;     ///< s
  double duration = 0.0;           ///< s
};

/// Decodes genomes of tests. Const and shared by threads; the same genome gives the same test.
class TestEncoding {
 public:
  virtual ~TestEncoding() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` where the space has no actuator for a test.
  virtual GenomeLayout layout(const TestSpace& space, std::span<const double> parameters) const = 0;
  /// A genome of a random test; uniform within the genes' bounds unless the encoding has a better distribution.
  virtual Genome random(const GenomeLayout& layout, RandomStream& random) const {
    return uniform_genome(layout, random);
  }
  /// The test of a genome that matches the layout.
  virtual Test decode(const TestSpace& space, std::span<const double> parameters,
                      std::span<const double> genome) const = 0;
};

}  // namespace lacuna
