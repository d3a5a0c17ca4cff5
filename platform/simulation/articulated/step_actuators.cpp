#include "simulation/articulated/step.h"
#include "simulation/articulated/step_weights.h"

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

constexpr double kCoupled = 1e6;  ///< times the larger of two coupled inertias
constexpr double kLeastRatio = 1e-6;

/// Share of the force that an actuator would exert at rest.
double share_of_supply(double sag, double force) { return 1.0 / (1.0 + sag * std::abs(force)); }

double beyond_gap(double twist, double gap) {
  const double half = 0.5 * gap;
  if (twist > half) return twist - half;
  return twist < -half ? twist + half : 0.0;
}

/// For a uniform motion through `twist` with length `way`, the mean part beyond the gap.
double share_beyond_gap(double twist, double way, double gap) {
  const double half = 0.5 * gap, reach = 0.5 * std::abs(way);
  if (reach == 0.0) return std::abs(twist) > half ? 1.0 : 0.0;
  const double within = std::min(twist + reach, half) - std::max(twist - reach, -half);
  return 1.0 - std::clamp(within / (2.0 * reach), 0.0, 1.0);
}

}  // namespace

/// The share of the step with a positive velocity decides.
double Step::imposed_friction(std::size_t c, double before, double after) const {
  const double change = after - before;
  double forward = 0.5;
  if (before * after < 0.0)
    forward = (change > 0.0 ? after : before) / std::abs(change);
  else if (before + after != 0.0)
    forward = before + after > 0.0 ? 1.0 : 0.0;
  return forward * loads_[c].friction_lower + (1.0 - forward) * loads_[c].friction_upper;
}

void Step::impose(std::size_t a, const Motion& from, double length, const Commanded& commanded) {
  const ActuatorNumbers& actuator = machine_.actuators()[a];
  const double left = commanded.end - (middle_time_ - 0.5 * length);
  const double before = from.velocities[actuator.dof];
  const double after = before + (commanded.values[a] - before) * std::min(1.0, length / left);
  if (!actuator.compliant)
    system_.right()[actuator.dof] += length * imposed_friction(actuator.coordinate, before, after);
  servo_law_[a] = laws_.size();
  laws_.push_back({.dof = actuator.dof, .resistance = kInfinity, .held_at = after});
}

void Step::add_actuator(std::size_t a, const Motion& from, double length, const Commanded& commanded) {
  const ActuatorNumbers& actuator = machine_.actuators()[a];
  const double command = commanded.values[a];
  servo_law_[a] = kNone;
  actuator_forces_[a] = 0.0;
  supply_shares_[a] = 1.0;
  if (std::isnan(command)) return;
  if (actuator.kind == ActuatorKind::motion) return impose(a, from, length, commanded);
  double& share = supply_shares_[a];
  const bool holds = actuator.sample_time > 0.0;
  if (actuator.kind == ActuatorKind::force || holds) {
    const double unsagged =
        holds ? from.integrals[a] : std::clamp(actuator.push * command, -actuator.limit, actuator.limit);
    share = share_of_supply(actuator.sag, unsagged);
    if (actuator.drag > 0.0) add_linear(actuator.dof, 0.0, share * actuator.drag, 0.0, from, length);
    actuator_forces_[a] = share * unsagged;
    system_.right()[actuator.dof] += length * actuator_forces_[a];
    return;
  }
  double force = actuator.kd * command, stiffness = 0.0;
  if (actuator.kind != ActuatorKind::velocity_servo) {
    const double error = command - middle_[actuator.position];
    force = actuator.kp * error;
    stiffness = actuator.kp;
    if (actuator.kind == ActuatorKind::pid) {
      force += actuator.ki * (from.integrals[a] + 0.5 * length * error) + actuator.kd * commanded.rates[a];
      stiffness += 0.5 * length * actuator.ki;
    }
  }
  if (actuator.sag > 0.0)
    share = share_of_supply(actuator.sag,
                            std::clamp(force - actuator.kd * mean_[actuator.dof], -actuator.limit, actuator.limit));
  if (actuator.drag > 0.0) add_linear(actuator.dof, 0.0, share * actuator.drag, 0.0, from, length);
  const Weights& w = weights_[actuator.dof];
  const double before = from.velocities[actuator.dof];
  servo_law_[a] = laws_.size();
  laws_.push_back(
      {.dof = actuator.dof,
       .push = share * length * (force - (actuator.kd * (1.0 - w.late) + stiffness * w.before * length) * before),
       .resistance = share * length * (actuator.kd * w.late + stiffness * w.after * length),
       .lower = -share * length * actuator.limit,
       .upper = share * length * actuator.limit});
}

void Step::add_transmission(std::size_t a, const Motion& from, double length) {
  const ActuatorNumbers& actuator = machine_.actuators()[a];
  if (!actuator.compliant) return;
  const CoordinateNumbers& joint = machine_.coordinates()[actuator.coordinate];
  const double twist = middle_[actuator.position] - middle_[joint.position];
  const double stretch = beyond_gap(twist, actuator.gap);
  double stiffness = actuator.stiffness, flank_damping = actuator.damping;
  if (actuator.gap > 0.0) {
    // A flank that is met or left within the step resists for its part of the step, because the damping jumps there.
    flank_damping *= share_beyond_gap(twist, length * (mean_[actuator.dof] - mean_[joint.dof]), actuator.gap);
    if (stretch == 0.0) stiffness = 0.0;
    if (stiffness == 0.0 && flank_damping == 0.0) return;
  }
  const double both = mobility(actuator.dof) + mobility(joint.dof);
  const SpringWeights spring = spring_weights(length * length * stiffness * both);
  const double late = late_damping(length * flank_damping * both);
  const double twisting = from.velocities[actuator.dof] - from.velocities[joint.dof];
  const double force =
      stiffness * stretch + (flank_damping * (1.0 - late) + stiffness * spring.before * length) * twisting;
  const double resistance = length * (flank_damping * late + stiffness * spring.after * length);
  const std::span<double> right = system_.right(), matrix = system_.matrix();
  right[joint.dof] += length * force;
  right[actuator.dof] -= length * force;
  matrix[joint.dof * (dofs_ + 1)] += resistance;
  matrix[actuator.dof * (dofs_ + 1)] += resistance;
  matrix[joint.dof * dofs_ + actuator.dof] -= resistance;
  matrix[actuator.dof * dofs_ + joint.dof] -= resistance;
}

/// A penalty inertia against the relative velocity of two coupled coordinates: so large that they hardly separate, but
/// small enough for the system to be solved. The remaining separation is removed from the positions after the step.
void Step::couple(std::span<double> matrix) const {
  for (const CouplingNumbers& c : machine_.couplings()) {
    const double own = inertia_[c.dof * (dofs_ + 1)], leading = inertia_[c.leading_dof * (dofs_ + 1)];
    const double heavy = kCoupled * std::max(own, leading / std::max(c.ratio * c.ratio, kLeastRatio));
    matrix[c.dof * (dofs_ + 1)] += heavy;
    matrix[c.leading_dof * (dofs_ + 1)] += heavy * c.ratio * c.ratio;
    matrix[c.dof * dofs_ + c.leading_dof] -= heavy * c.ratio;
    matrix[c.leading_dof * dofs_ + c.dof] -= heavy * c.ratio;
  }
}

}  // namespace lacuna::articulated
