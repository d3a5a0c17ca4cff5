#include "simulation/ode/coupled_coordinates.h"

#include <algorithm>
#include <cmath>

namespace lacuna::ode {
namespace {

constexpr int kMostSearches = 100;     ///< a few are enough but where rounding has the last word
constexpr double kSettled = 1e-28;     ///< of the energy: a last change that is rounding
constexpr double kNotMoving = 1e-100;  ///< square of a velocity

enum class Regime { at_lower, within, at_upper };

Regime regime_of(const CoordinateLaw& law, double velocity) {
  const double missing = law.target - velocity;
  if (missing > law.compliance * law.upper) return Regime::at_upper;
  return missing < law.compliance * law.lower ? Regime::at_lower : Regime::within;
}

}  // namespace

CoupledCoordinates::CoupledCoordinates(int coordinates, double step, std::size_t laws)
    : count_(coordinates), step_(step) {
  along_.reserve(laws);
}

void CoupledCoordinates::settle(std::span<const CoordinateLaw> laws, Column& velocity) {
  for (int i = 0; i < count_; ++i)
    for (int j = 0; j < count_; ++j) push[i] += inertia(i, j) * offset[j];
  for (int search = 0; search < kMostSearches; ++search)
    if (settle_in_regime(laws, velocity)) return;
}

/// Newton's step: goes to where the laws would hold if each stayed at its limit, or within, as it is at `velocity`.
/// True if they do stay; else goes only so far on this way as is best.
bool CoupledCoordinates::settle_in_regime(std::span<const CoordinateLaw> laws, Column& velocity) {
  Square matrix;
  matrix.topLeftCorner(count_, count_) = inertia.topLeftCorner(count_, count_);
  Column solution = push;
  for (const CoordinateLaw& law : laws) {
    const auto i = static_cast<Eigen::Index>(law.coordinate);
    switch (regime_of(law, velocity[i])) {
      case Regime::at_upper: solution[i] += step_ * law.upper; break;
      case Regime::at_lower: solution[i] += step_ * law.lower; break;
      case Regime::within:
        solution[i] += step_ / law.compliance * law.target;
        matrix(i, i) += step_ / law.compliance;
        break;
    }
  }
  solve(matrix, solution);
  const bool stays = std::all_of(laws.begin(), laws.end(), [&](const CoordinateLaw& law) {
    const auto i = static_cast<Eigen::Index>(law.coordinate);
    return regime_of(law, solution[i]) == regime_of(law, velocity[i]);
  });
  if (stays) {
    velocity = solution;
    return true;
  }
  Column direction = solution;
  for (int i = 0; i < count_; ++i) direction[i] -= velocity[i];
  if (energy(matrix, direction) <= kSettled * energy(matrix, solution)) return true;
  search_along(laws, direction, velocity);
  return false;
}

/// On a straight way all coordinates are one, and their laws are laws on it.
void CoupledCoordinates::search_along(std::span<const CoordinateLaw> laws, const Column& direction, Column& velocity) {
  double pushed = 0.0, inertia_along = 0.0;
  for (int i = 0; i < count_; ++i) {
    double missing = push[i], resisting = 0.0;
    for (int j = 0; j < count_; ++j) {
      missing -= inertia(i, j) * velocity[j];
      resisting += inertia(i, j) * direction[j];
    }
    pushed += direction[i] * missing;
    inertia_along += direction[i] * resisting;
  }
  along_.clear();
  for (const CoordinateLaw& law : laws) {
    const auto i = static_cast<Eigen::Index>(law.coordinate);
    const double share = direction[i];
    if (share * share < kNotMoving) continue;
    const auto [lower, upper] = std::minmax({share * law.lower, share * law.upper});
    along_.push_back({.target = (law.target - velocity[i]) / share,
                      .compliance = law.compliance / (share * share),
                      .lower = lower,
                      .upper = upper});
  }
  const double way = settled_velocity(pushed / inertia_along, step_ / inertia_along, along_);
  for (int i = 0; i < count_; ++i) velocity[i] += way * direction[i];
}

/// Twice the energy of a motion, given the eliminated inertia.
double CoupledCoordinates::energy(const Square& eliminated, const Column& motion) const {
  double energy = 0.0;
  for (int j = 0; j < count_; ++j) {
    double part = 0.0;
    for (int i = j; i < count_; ++i) part += eliminated(i, j) * motion[i];
    energy += part * part / eliminated(j, j);
  }
  return energy;
}

/// By elimination, whose columns stay in the lower triangle; the right-hand side becomes the solution.
void CoupledCoordinates::solve(Square& matrix, Column& right) const {
  Column inverse;
  for (int j = 0; j < count_; ++j) {
    inverse[j] = 1.0 / matrix(j, j);
    for (int i = j + 1; i < count_; ++i) {
      const double share = matrix(i, j) * inverse[j];
      for (int k = j + 1; k <= i; ++k) matrix(i, k) -= share * matrix(k, j);
      right[i] -= share * right[j];
    }
  }
  for (int j = count_ - 1; j >= 0; --j) {
    for (int i = j + 1; i < count_; ++i) right[j] -= matrix(i, j) * right[i];
    right[j] *= inverse[j];
  }
}

}  // namespace lacuna::ode
