#pragma once

#include "simulation/articulated/random_tree.h"
#include "simulation/articulated/tree.h"

#include <mujoco/mujoco.h>

#include <memory>
#include <span>
#include <vector>

namespace lacuna {

/// A tree as MuJoCo has it, which counts the same motion by other numbers: turns of ball joints and floating bodies in
/// the body's own axes.
class MujocoRobot {
 public:
  explicit MujocoRobot(const RandomTree& tree);

  /// Accelerations without forces but gravity, at a configuration and at velocities; all as `links` counts them.
  std::vector<double> accelerations(const std::vector<articulated::Link>& links, std::span<const double> configuration,
                                    std::span<const double> velocities);

 private:
  void put(const articulated::Link& link, const double* q, const double* v);
  void read_accelerations(const articulated::Link& link, const double* q, double* out) const;
  int joint_of(const articulated::Link& link) const;
  /// From the axes in which a ball or floating link's velocity is counted to those of its body, at its configuration.
  Eigen::Quaterniond axes(const articulated::Link& link, const double* q) const;
  Eigen::Quaterniond at_zero(const articulated::Link& link) const;

  RobotSpec robot_;
  std::vector<int> parents_;
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_;
};

}  // namespace lacuna
