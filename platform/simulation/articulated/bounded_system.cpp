#include "simulation/articulated/bounded_system.h"

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

constexpr int kAllAtOnce = 8;  ///< simultaneous changes of regimes, before they are changed one by one
constexpr int kMost = 1000;    ///< reached only through rounding

}  // namespace

bool factor_in_place(std::span<double> matrix, std::size_t size) {
  for (std::size_t j = 0; j < size; ++j) {
    double* row = &matrix[j * size];
    double rest = row[j];
    for (std::size_t k = 0; k < j; ++k) rest -= row[k] * row[k];
    if (!(rest > 0.0)) return false;
    row[j] = std::sqrt(rest);
    const double inverse = 1.0 / row[j];
    for (std::size_t i = j + 1; i < size; ++i) {
      double* below = &matrix[i * size];
      double sum = below[j];
      for (std::size_t k = 0; k < j; ++k) sum -= below[k] * row[k];
      below[j] = sum * inverse;
    }
  }
  return true;
}

void solve_in_place(std::span<const double> factor, std::size_t size, std::span<double> right) {
  for (std::size_t i = 0; i < size; ++i) {
    double sum = right[i];
    for (std::size_t k = 0; k < i; ++k) sum -= factor[i * size + k] * right[k];
    right[i] = sum / factor[i * size + i];
  }
  for (std::size_t i = size; i-- > 0;) {
    double sum = right[i];
    for (std::size_t k = i + 1; k < size; ++k) sum -= factor[k * size + i] * right[k];
    right[i] = sum / factor[i * size + i];
  }
}

double inverse_diagonal(std::span<const double> factor, std::size_t size, std::size_t element,
                        std::span<double> memory) {
  double sum = 0.0;
  for (std::size_t i = element; i < size; ++i) {
    double part = i == element ? 1.0 : 0.0;
    for (std::size_t k = element; k < i; ++k) part -= factor[i * size + k] * memory[k];
    memory[i] = part / factor[i * size + i];
    sum += memory[i] * memory[i];
  }
  return sum;
}

BoundedSystem::BoundedSystem(std::size_t dofs, std::size_t laws)
    : dofs_(dofs),
      matrix_(dofs * dofs),
      right_(dofs),
      factor_(dofs * dofs),
      pushed_(dofs),
      regimes_(laws),
      impulses_(laws) {}

void BoundedSystem::solve(std::span<const VelocityLaw> laws, std::span<double> velocities, bool again) {
  if (!again) {
    std::fill(regimes_.begin(), regimes_.end(), Regime::within);
    factor_in_regimes(laws);
  }
  for (int change = 0; change < kMost; ++change) {
    if (change > 0) factor_in_regimes(laws);
    solve_in_regimes(laws, velocities);
    if (!change_regimes(laws, velocities, change < kAllAtOnce)) return;
  }
}

/// A rigid law within its limits removes its velocity: the row and the column are those of the unit matrix.
void BoundedSystem::factor_in_regimes(std::span<const VelocityLaw> laws) {
  std::copy(matrix_.begin(), matrix_.end(), factor_.begin());
  for (std::size_t l = 0; l < laws.size(); ++l)
    if (regimes_[l] == Regime::within && !laws[l].rigid()) factor_[laws[l].dof * (dofs_ + 1)] += laws[l].resistance;
  for (std::size_t l = 0; l < laws.size(); ++l) {
    if (regimes_[l] != Regime::within || !laws[l].rigid()) continue;
    const std::size_t held = laws[l].dof;
    for (std::size_t i = 0; i < dofs_; ++i) factor_[held * dofs_ + i] = factor_[i * dofs_ + held] = 0.0;
    factor_[held * (dofs_ + 1)] = 1.0;
  }
  factor_in_place(factor_, dofs_);
}

void BoundedSystem::solve_in_regimes(std::span<const VelocityLaw> laws, std::span<double> velocities) {
  std::copy(right_.begin(), right_.end(), pushed_.begin());
  for (std::size_t l = 0; l < laws.size(); ++l) {
    const VelocityLaw& law = laws[l];
    if (regimes_[l] == Regime::at_lower) pushed_[law.dof] += law.lower;
    if (regimes_[l] == Regime::at_upper) pushed_[law.dof] += law.upper;
    if (regimes_[l] == Regime::within && !law.rigid()) pushed_[law.dof] += law.push;
  }
  std::copy(pushed_.begin(), pushed_.end(), velocities.begin());
  for (std::size_t l = 0; l < laws.size(); ++l) {
    if (regimes_[l] != Regime::within || !laws[l].rigid() || laws[l].held_at == 0.0) continue;
    for (std::size_t i = 0; i < dofs_; ++i) velocities[i] -= matrix_[i * dofs_ + laws[l].dof] * laws[l].held_at;
  }
  for (std::size_t l = 0; l < laws.size(); ++l)
    if (regimes_[l] == Regime::within && laws[l].rigid()) velocities[laws[l].dof] = laws[l].held_at;
  solve_in_place(factor_, dofs_, velocities);
}

/// The impulse that a law would have without its limits.
double BoundedSystem::needed(const VelocityLaw& law, std::span<const double> velocities) const {
  if (!law.rigid()) return law.push - law.resistance * velocities[law.dof];
  double momentum = -pushed_[law.dof];
  for (std::size_t i = 0; i < dofs_; ++i) momentum += matrix_[law.dof * dofs_ + i] * velocities[i];
  return momentum;
}

BoundedSystem::Regime BoundedSystem::regime_at(const VelocityLaw& law, Regime now, double impulse,
                                               double velocity) const {
  if (law.rigid() && now != Regime::within) {
    const bool yields = now == Regime::at_lower ? velocity >= law.held_at : velocity <= law.held_at;
    return yields ? now : Regime::within;
  }
  if (impulse > law.upper) return Regime::at_upper;
  return impulse < law.lower ? Regime::at_lower : Regime::within;
}

bool BoundedSystem::change_regimes(std::span<const VelocityLaw> laws, std::span<const double> velocities, bool all) {
  bool changed = false;
  for (std::size_t l = 0; l < laws.size() && (all || !changed); ++l) {
    const double wanted = needed(laws[l], velocities);
    impulses_[l] = std::clamp(wanted, laws[l].lower, laws[l].upper);
    if (laws[l].rigid() && regimes_[l] != Regime::within)
      impulses_[l] = regimes_[l] == Regime::at_lower ? laws[l].lower : laws[l].upper;
    const Regime right = regime_at(laws[l], regimes_[l], wanted, velocities[laws[l].dof]);
    changed = changed || right != regimes_[l];
    regimes_[l] = right;
  }
  return changed;
}

}  // namespace lacuna::articulated
