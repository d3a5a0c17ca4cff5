#pragma once

#include <lacuna/genome.h>
#include <lacuna/parameter.h>
#include <lacuna/random_stream.h>
#include <lacuna/robot_spec.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// An effect of the experiment's model.
struct ModelEffect {
  std::string id;
  bool optional = false;            ///< a model may leave it out
  std::vector<std::size_t> values;  ///< its parameters, as indices into `ModelSpace::free`
};

/// The parts from which an encoding makes models.
struct ModelSpace {
  const RobotSpec& robot;                 ///< the experiment's robot, with start values
  std::vector<FreeParameter> free;        ///< the experiment's free parameters, including those of effects
  std::vector<ModelEffect> effects = {};  ///< of the experiment's model, in its order
};

/// A model from a genome: values of the free parameters, the effects that it leaves out, and, for an encoding that
/// builds robots, the robot that replaces the experiment's.
struct ModelProposal {
  std::vector<double> values;  ///< of `ModelSpace::free`, in its order, SI, within their bounds
  /// None: the experiment's robot. Otherwise one with the same bodies, joints, actuators and sensors, by name, kind and
  /// order, so that channels, effects and addresses keep their meaning. Positions and attachments may differ, but
  /// sensors and actuators of joints stay on joints of their kind. Shared: a model may outlive the genome it came from.
  std::shared_ptr<const RobotSpec> robot = nullptr;
  /// Optional effects that the model leaves out, as ascending indices into `ModelSpace::effects`; the `values` of their
  /// parameters are not used.
  std::vector<std::size_t> without = {};
  /// The hypothesis of the model: a tree of parts, a set of effects. Models of different structures are alternatives,
  /// and the algorithm keeps the best of each; empty: there is only one structure. A short text for people.
  std::string structure = {};
};

/// Decodes genomes of models. Const and shared by threads; the same genome gives the same model.
class ModelEncoding {
 public:
  virtual ~ModelEncoding() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` where the space has nothing to encode: no free parameters for an encoding of values, no optional
  /// effects for one of switches, no bodies and joints for one of robots.
  virtual GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const = 0;
  /// A genome of a random model; uniform within the genes' bounds unless the encoding has a better distribution.
  virtual Genome random(const GenomeLayout& layout, RandomStream& random) const {
    return uniform_genome(layout, random);
  }
  /// The model of a genome that matches the layout. Two genomes with equal proposals have the same phenotype.
  virtual ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                               std::span<const double> genome) const = 0;
};

}  // namespace lacuna
