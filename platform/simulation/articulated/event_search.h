#pragma once

#include "simulation/articulated/step.h"

#include <optional>

namespace lacuna::articulated {

/// What happens to a coordinate within a step and cuts it in two.
enum class EventKind { rests, meets_lower, meets_upper };

struct Event {
  std::size_t coordinate = 0;
  EventKind kind = EventKind::rests;
};

/// Finds the first moment of a step at which a coordinate with dry friction comes to rest or one meets a stop. The
/// moment is that of the step itself, taken shorter, to rounding: so dry friction turns round where the velocity does,
/// and a step that holds such a moment has the order of the others.
class EventSearch {
 public:
  EventSearch(const Machine& machine, Step& step) : machine_(machine), step_(step) {}

  /// What one step needs besides its length.
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
  /// After a step of this length was taken. Where there is an event, the step up to it was taken last.
  std::optional<Found> first(const Setting& setting, double length);

 private:
  /// Positive before the event, negative behind it.
  double distance(const Event& event, const Motion& from, const Motion& now) const;
  std::optional<Event> earliest(const Setting& setting) const;
  double locate(const Event& event, const Setting& setting, double length);
  void take(const Setting& setting, double length);

  const Machine& machine_;
  Step& step_;
};

}  // namespace lacuna::articulated
