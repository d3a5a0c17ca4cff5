#pragma once

#include "mjcf_defaults.h"
#include "mjcf_document.h"

#include "rigid_mass.h"

namespace lacuna::mjcf {

using robot_files::Pose;

enum class InertiaFromGeom { never, where_missing, always };

/// The settings of <compiler> and <option> for the whole model. Of several sections the last one with a setting counts.
struct Settings {
  bool degrees = true;
  std::string euler_axes = "xyz";  ///< lower case: rotating axes, upper case: fixed ones
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::where_missing;
  bool balance_inertia = false;
  double least_mass = 0.0;              ///< kg, of a body
  double least_inertia = 0.0;           ///< kg·m², principal
  double total_mass = 0.0;              ///< kg, total to which all masses are scaled; 0: not scaled
  bool auto_limits = true;              ///< a written range is active
  int first_group = 0, last_group = 5;  ///< range of groups of geoms that have mass
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};

  double angle(double written) const;  ///< rad
};

Settings read_settings(const Document& document, std::vector<RobotRemark>& remarks);

/// Pose of an element in its parent: its pos, and one of quat, euler, axisangle, xyaxes, zaxis. Two of them are a
/// problem.
Pose pose_of(const Attributes& element, const Settings& settings);
Pose pose_of(const XmlElement& element, const Settings& settings);

}  // namespace lacuna::mjcf
