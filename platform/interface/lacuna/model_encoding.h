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

/// One number of a model that may vary, within its search bounds.
struct FreeParameter {
  std::string address;  ///< `body.torso.mass`
  std::string unit;     ///< SI
  double lower = 0.0;
  double upper = 0.0;
  double start = 0.0;  ///< where nothing is known better
  Scale scale = Scale::linear;
};

/// An effect of the experiment's model.
struct ModelEffect {
  std::string id;
  bool optional = false;            ///< a model may do without it
  std::vector<std::size_t> values;  ///< its parameters, as indices into `ModelSpace::free`
};

/// What an encoding's models are made from.
struct ModelSpace {
  const RobotSpec& robot;                 ///< the experiment's robot, start values in place
  std::vector<FreeParameter> free;        ///< what the experiment frees, effects' parameters included
  std::vector<ModelEffect> effects = {};  ///< of the experiment's model, in its order
};

/// A model as a genome says it: values for what the experiment frees, the effects that it does without and, of an
/// encoding that builds robots, the robot that takes the place of the experiment's.
struct ModelProposal {
  std::vector<double> values;  ///< of `ModelSpace::free`, in its order, SI, within their bounds
  /// None: the experiment's robot. Otherwise one with the same bodies, joints, actuators and sensors, by name, kind and
  /// in order, so that channels, effects and addresses keep their meaning; where they are and what hangs on what may
  /// differ, but sensors and actuators of joints stay on joints of their kind. Shared: a model that is handed on
  /// outlives the genome it came from.
  std::shared_ptr<const RobotSpec> robot = nullptr;
  /// Effects that the model does without, as ascending indices into `ModelSpace::effects`, optional ones alone; what
  /// `values` says of their parameters means nothing.
  std::vector<std::size_t> without = {};
  /// Which hypothesis the model is of: a tree of parts, a set of effects. Models of different structures are rivals, of
  /// which the algorithm keeps the best of each; empty: there is only one. Short, for people to read.
  std::string structure = {};
};

/// What a genome of models means. Const and shared by threads; the same genome gives the same model.
class ModelEncoding {
 public:
  virtual ~ModelEncoding() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` where the space has nothing to encode: without free parameters an encoding of values, without
  /// optional effects one that switches them, without bodies and joints one of robots.
  virtual GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const = 0;
  /// A genome of a random model; uniform within the genes' bounds unless an encoding knows better.
  virtual Genome random(const GenomeLayout& layout, RandomStream& random) const {
    return uniform_genome(layout, random);
  }
  /// The model of a genome that fits the layout. Two genomes with equal proposals are one phenotype.
  virtual ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                               std::span<const double> genome) const = 0;
};

}  // namespace lacuna
