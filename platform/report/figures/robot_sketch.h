#pragma once

#include <lacuna/robot_spec.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace lacuna {

/// Of a part, by its index.
const char* part_colour(std::size_t part);
inline constexpr double kBelowGround = 0.3;  ///< opacity of what is there

std::string svg_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, const char* colour,
                     double opacity);
/// Of a beacon.
std::string svg_dot(const Eigen::Vector2d& place);

/// A robot of cylinders and capsules from above at a slant, on a grid of 1 m with its beacons. Places from the origin
/// in px, right and down.
class RobotSketch {
 public:
  explicit RobotSketch(const RobotSpec& robot);

  /// What of the plane it takes.
  Eigen::AlignedBox2d box() const { return {scale_ * box_.min(), scale_ * box_.max()}; }
  /// Below 1 where it would reach too far.
  double scale() const { return scale_; }
  std::string svg() const;

 private:
  /// A stretch of a part's axis.
  struct Stick {
    Eigen::Vector3d from, to;
    double width;  ///< px, of a drawing that is not made smaller
    const char* colour;
    bool below;
  };
  void add_part(const BodySpec& body, const char* colour);
  void add_stretch(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width, const char* colour);
  void hold(const Eigen::Vector3d& place, double about);
  std::string ground() const;

  const RobotSpec& robot_;
  std::vector<Stick> sticks_;
  Eigen::AlignedBox2d box_;
  double scale_ = 1.0;
};

}  // namespace lacuna
