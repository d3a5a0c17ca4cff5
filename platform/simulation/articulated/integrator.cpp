#include "simulation/articulated/integrator.h"

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

constexpr int kMostEvents = 12;  ///< events in one step; then dry friction acts on the velocities after the rest of it

}  // namespace

Integrator::Integrator(const Machine& machine, const simulation::ElementCoordinates& elements)
    : machine_(machine),
      step_(machine, elements),
      search_(machine, step_),
      stopped_(machine.coordinates().size(), Contact::free),
      coordinate_forces_(machine.coordinates().size(), 0.0) {
  motion_.configuration.resize(machine.positions());
  motion_.velocities.resize(machine.dofs());
  motion_.accelerations.resize(machine.dofs());
  motion_.integrals.resize(machine.actuators().size());
}

void Integrator::forget() {
  std::fill(coordinate_forces_.begin(), coordinate_forces_.end(), 0.0);
  std::fill(step_.actuator_forces().begin(), step_.actuator_forces().end(), 0.0);
}

void Integrator::look_at_stops() {
  for (std::size_t c = 0; c < stopped_.size(); ++c) {
    const CoordinateNumbers& numbers = machine_.coordinates()[c];
    stopped_[c] = Contact::free;
    if (numbers.ball || numbers.imposed) continue;
    const double position = motion_.configuration[numbers.position];
    const double velocity = motion_.velocities[numbers.dof];
    if (position >= numbers.upper && velocity >= 0.0)
      stopped_[c] = Contact::at_upper;
    else if (position <= numbers.lower && velocity <= 0.0)
      stopped_[c] = Contact::at_lower;
  }
}

/// A start may contradict the coupling.
void Integrator::begin_imposed(double length, const Commanded& commanded) {
  for (std::size_t a = 0; a < machine_.actuators().size(); ++a)
    if (machine_.actuators()[a].kind == ActuatorKind::motion && !std::isnan(commanded.values[a]))
      motion_.velocities[machine_.actuators()[a].dof] = commanded.values[a] - length * commanded.rates[a];
}

void Integrator::advance(double begin, double length, const Commanded& commanded, const Eigen::Vector3d& gravity) {
  std::fill(coordinate_forces_.begin(), coordinate_forces_.end(), 0.0);
  begin_imposed(length, commanded);
  double left = length;
  for (int events = 0; left > 0.0; ++events) {
    look_at_stops();
    const double now = begin + (length - left);
    const bool cut = events < kMostEvents;
    step_.take(motion_, now, left, commanded, stopped_, !cut, gravity);
    const auto found =
        cut ? search_.first({motion_, now, commanded, stopped_, gravity}, left) : std::optional<EventSearch::Found>();
    const double taken = found ? found->length : left;
    keep(taken, length, commanded);
    if (found) carry_out(found->event);
    left = found && taken < left ? left - taken : 0.0;
  }
}

void Integrator::keep(double length, double whole, const Commanded& commanded) {
  step_.keep();
  for (std::size_t c = 0; c < coordinate_forces_.size(); ++c)
    coordinate_forces_[c] += length / whole * step_.coordinate_force(c);
  const Motion& after = step_.after();
  std::copy(after.configuration.begin(), after.configuration.end(), motion_.configuration.begin());
  std::copy(after.velocities.begin(), after.velocities.end(), motion_.velocities.begin());
  std::copy(after.accelerations.begin(), after.accelerations.end(), motion_.accelerations.begin());
  for (const CouplingNumbers& c : machine_.couplings()) {
    motion_.configuration[c.position] = c.ratio * motion_.configuration[c.leading_position] + c.offset;
    motion_.velocities[c.dof] = c.ratio * motion_.velocities[c.leading_dof];
  }
  for (std::size_t a = 0; a < motion_.integrals.size(); ++a)
    motion_.integrals[a] += length * step_.integral_rate(a, commanded.values[a]);
}

void Integrator::carry_out(const Event& event) {
  const CoordinateNumbers& numbers = machine_.coordinates()[event.coordinate];
  if (event.kind == EventKind::rests) {
    motion_.velocities[numbers.dof] = 0.0;
    return;
  }
  motion_.configuration[numbers.position] = event.kind == EventKind::meets_lower ? numbers.lower : numbers.upper;
  step_.stop(event.coordinate, motion_);
}

}  // namespace lacuna::articulated
