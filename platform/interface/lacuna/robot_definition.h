#pragma once

#include <lacuna/parameter.h>
#include <lacuna/robot_spec.h>

#include <span>

namespace lacuna {

/// The input of a robot definition.
struct RobotRequest {
  std::span<const double> parameters;   ///< one value for each of `parameters()`, in its order, SI
  const RobotSpec* declared = nullptr;  ///< the content of the robot file that the experiment names, else null
};

/// Makes a robot. Const and shared by threads; the same request gives the same robot.
class RobotDefinition {
 public:
  virtual ~RobotDefinition() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` where no robot can be made from the request.
  virtual RobotSpec build(const RobotRequest& request) const = 0;
};

}  // namespace lacuna
