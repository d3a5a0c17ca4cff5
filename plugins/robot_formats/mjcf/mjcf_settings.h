#pragma once

#include "mjcf_defaults.h"
#include "mjcf_document.h"

#include "rigid_mass.h"

namespace lacuna::mjcf {

using robot_files::Pose;

enum class InertiaFromGeom { never, where_missing, always };

/// What <compiler> and <option> say for the whole model. Of several sections the last that says it counts.
struct Settings {
  bool degrees = true;
  std::string euler_axes = "xyz";  ///< small: turned axes, large: fixed ones
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::where_missing;
  bool balance_inertia = false;
  double least_mass = 0.0;              ///< kg, of a body
  double least_inertia = 0.0;           ///< kg·m², principal
  double total_mass = 0.0;              ///< kg, to which all are scaled; 0: they are not
  bool auto_limits = true;              ///< a range that is written is meant
  int first_group = 0, last_group = 5;  ///< of geoms that have mass
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};

  double angle(double written) const;  ///< rad
};

Settings read_settings(const Document& document, std::vector<RobotRemark>& remarks);

/// Where an element stands in the one around it: its pos, and of quat, euler, axisangle, xyaxes, zaxis the one that is
/// written. Two of them are a problem.
Pose pose_of(const Attributes& element, const Settings& settings);
Pose pose_of(const XmlElement& element, const Settings& settings);

}  // namespace lacuna::mjcf
