#pragma once

#include "simulation/articulated/step.h"

#include <optional>

namespace lacuna::articulated {

/// An event of a coordinate that divides a step.
enum class EventKind { rests, meets_lower, meets_upper };

struct Event {
  std::size_t coordinate = 0;
  EventKind kind = EventKind::rests;
};

/// Finds the first time in a step at which a coordinate with dry friction comes to rest or a coordinate meets a stop.
/// The time is that of a shortened step, to rounding. So dry friction changes its sign together with the velocity, and
/// a step with such an event keeps its order.
class EventSearch {
 public:
  EventSearch(const Machine& machine, Step& step) : machine_(machine), step_(step) {}

  /// Input of one step besides its length.
  struct Setting {
    const Motion& from;
    double begin = 0.0;
    const Commanded& commanded;
    std::span<const Contact> stopped;
    const Eigen::Vector3d& gravity;
  };

  struct Found {
    Event event;
    double length = 0.0;  ///< of the step up to it
  };
  /// After a step of this length. With an event, the last step taken ends at it.
  std::optional<Found> first(const Setting& setting, double length);

 private:
  /// Positive before the event, negative after it.
  double distance(const Event& event, const Motion& from, const Motion& now) const;
  std::optional<Event> earliest(const Setting& setting) const;
  double locate(const Event& event, const Setting& setting, double length);
  void take(const Setting& setting, double length);

  const Machine& machine_;
  Step& step_;
};

}  // namespace lacuna::articulated
