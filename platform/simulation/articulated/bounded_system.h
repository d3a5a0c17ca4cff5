#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace lacuna::articulated {

/// A law on one velocity after a step: an impulse within [lower, upper], push − resistance·velocity where that is
/// within. An infinite resistance holds the velocity at `held_at`: zero for stiction and stops, or the value of an
/// imposed motion.
struct VelocityLaw {
  std::size_t dof = 0;
  double push = 0.0, resistance = 0.0;
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  double held_at = 0.0;

  bool rigid() const { return resistance == std::numeric_limits<double>::infinity(); }
};

/// The velocities v after a step with bounded laws: matrix·v = right + the laws' impulses. No impulse grows with its
/// velocity and the matrix is positive definite, so that there is exactly one solution: a box-constrained linear
/// complementarity problem, solved by changing the laws that are in the wrong regime, all at once at first, then one by
/// one (K. G. Murty, "Note on a Bard-type scheme for solving the complementarity problem", Opsearch 11 (1974) 123-130),
/// which terminates. Allocates nothing after construction.
class BoundedSystem {
 public:
  /// `laws`: the largest number in a step; of rigid ones, at most one per dof.
  BoundedSystem(std::size_t dofs, std::size_t laws);

  std::span<double> matrix() { return matrix_; }  ///< dofs × dofs; both triangles, symmetric
  std::span<double> right() { return right_; }

  /// `again`: same matrix and laws as in the last call, another right-hand side.
  void solve(std::span<const VelocityLaw> laws, std::span<double> velocities, bool again = false);
  /// The impulse of a law in the solution.
  double impulse(std::size_t law) const { return impulses_[law]; }

 private:
  enum class Regime : unsigned char { at_lower, within, at_upper };

  void factor_in_regimes(std::span<const VelocityLaw> laws);
  void solve_in_regimes(std::span<const VelocityLaw> laws, std::span<double> velocities);
  Regime regime_at(const VelocityLaw& law, Regime now, double impulse, double velocity) const;
  double needed(const VelocityLaw& law, std::span<const double> velocities) const;
  bool change_regimes(std::span<const VelocityLaw> laws, std::span<const double> velocities, bool all);

  std::size_t dofs_;
  std::vector<double> matrix_, right_, factor_, pushed_;
  std::vector<Regime> regimes_;
  std::vector<double> impulses_;
};

/// Factors a symmetric positive definite matrix in place, L in the lower triangle of rows of `size` numbers; false: it
/// is not positive definite.
bool factor_in_place(std::span<double> matrix, std::size_t size);
/// Solves with such a factor in place.
void solve_in_place(std::span<const double> factor, std::size_t size, std::span<double> right);
/// A diagonal element of the inverse of the factored matrix. `memory`: `size` numbers.
double inverse_diagonal(std::span<const double> factor, std::size_t size, std::size_t element,
                        std::span<double> memory);

}  // namespace lacuna::articulated
