#pragma once

#include "simulation/ode/coordinate_law.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace lacuna::ode {

/// Joint coordinates that move each other, and the laws that each of them must keep at the end of a step:
/// inertia·(velocity − offset) = push + step·force, where the laws give the force of each coordinate.
class CoupledCoordinates {
 public:
  static constexpr int kMost = 8;
  using Square = Eigen::Matrix<double, kMost, kMost>;
  using Column = Eigen::Matrix<double, kMost, 1>;

  /// `laws`: the most that a step can have.
  CoupledCoordinates(int coordinates, double step, std::size_t laws);

  // Of the coming step; only the first rows and columns count, `inertia` is symmetric and positive definite.
  Square inertia;
  Column push;    ///< momentum that the coordinates have without the laws
  Column offset;  ///< of the velocities that the laws know, from those that the momentum is of

  /// The velocities at which all laws hold, `velocity` being a guess. There is exactly one such: they are where a
  /// strictly convex function, quadratic between the places at which a law reaches a limit, is least.
  void settle(std::span<const CoordinateLaw> laws, Column& velocity);

 private:
  bool settle_in_regime(std::span<const CoordinateLaw> laws, Column& velocity);
  void search_along(std::span<const CoordinateLaw> laws, const Column& direction, Column& velocity);
  void solve(Square& matrix, Column& right) const;
  double energy(const Square& eliminated, const Column& motion) const;

  int count_;
  double step_;
  std::vector<CoordinateLaw> along_;
};

}  // namespace lacuna::ode
