#pragma once

#include "simulation/articulated/event_search.h"
#include "simulation/articulated/step.h"

#include <span>
#include <vector>

namespace lacuna::articulated {

/// Moves a machine through whole steps, each divided where a coordinate comes to rest or meets a stop.
class Integrator {
 public:
  Integrator(const Machine& machine, const simulation::ElementCoordinates& elements);

  Step& step() { return step_; }
  Motion& motion() { return motion_; }
  const Motion& motion() const { return motion_; }

  void advance(double begin, double length, const Commanded& commanded, const Eigen::Vector3d& gravity);

  /// Mean over the last whole step.
  std::span<const double> coordinate_forces() const { return coordinate_forces_; }
  /// The memory of earlier steps, except the motion.
  void forget();

 private:
  void begin_imposed(double length, const Commanded& commanded);
  void look_at_stops();
  void keep(double length, double whole, const Commanded& commanded);
  void carry_out(const Event& event);

  const Machine& machine_;
  Step step_;
  EventSearch search_;
  Motion motion_;
  std::vector<Contact> stopped_;
  std::vector<double> coordinate_forces_;
};

}  // namespace lacuna::articulated
