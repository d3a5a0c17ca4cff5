#pragma once

#include <lacuna/parameter.h>
#include <lacuna/robot_spec.h>

#include <span>

namespace lacuna {

/// What a robot is made from.
struct RobotRequest {
  std::span<const double> parameters;   ///< one value for each of `parameters()`, in its order, SI
  const RobotSpec* declared = nullptr;  ///< the robot file's content where the experiment names one, else null
};

/// Makes a robot. Const and shared by threads; the same request gives the same robot.
class RobotDefinition {
 public:
  virtual ~RobotDefinition() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` where the request cannot become a robot.
  virtual RobotSpec build(const RobotRequest& request) const = 0;
};

}  // namespace lacuna
