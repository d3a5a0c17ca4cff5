#pragma once

#include <lacuna/robot_spec.h>

#include <random>
#include <vector>

namespace lacuna {

/// Numbers between −1 and 1 that are the same on every machine.
class Draws {
 public:
  explicit Draws(unsigned seed) : generator_(seed) {}
  double number() { return 2.0 * (static_cast<double>(generator_()) / 4294967296.0) - 1.0; }
  int below(int count) { return static_cast<int>(0.5 * (number() + 1.0) * count); }
  Eigen::Vector3d vector();
  Eigen::Quaterniond turn();

 private:
  std::mt19937 generator_;
};

/// A robot that is one tree of bodies on hinges, sliders, universal and ball joints, all numbers drawn.
struct RandomTree {
  RobotSpec robot;
  std::vector<int> parents;  ///< per body: body, −1: the world
};

/// `floating`: no joint holds the first body.
RandomTree random_tree(int bodies, bool floating, Draws& draws);

}  // namespace lacuna
