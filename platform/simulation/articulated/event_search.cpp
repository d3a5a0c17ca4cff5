#include "simulation/articulated/event_search.h"

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

constexpr int kMostTrials = 60;
constexpr double kLocated = 1e-10;    ///< of the step, its shortest length, or of the distance at its start
constexpr double kSameMoment = 1e-8;  ///< of the way to an event, within which two events coincide
constexpr double kTold = 1e-12;       ///< of the fastest velocity: a step tells no smaller ones

double fastest(const Motion& motion) {
  double most = 0.0;
  for (const double velocity : motion.velocities) most = std::max(most, std::abs(velocity));
  return most;
}

}  // namespace

void EventSearch::take(const Setting& setting, double length) {
  step_.take(setting.from, setting.begin, length, setting.commanded, setting.stopped, false, setting.gravity);
}

double EventSearch::distance(const Event& event, const Motion& from, const Motion& now) const {
  const CoordinateNumbers& c = machine_.coordinates()[event.coordinate];
  switch (event.kind) {
    case EventKind::rests: return from.velocities[c.dof] > 0.0 ? now.velocities[c.dof] : -now.velocities[c.dof];
    case EventKind::meets_lower: return now.configuration[c.position] - c.lower;
    case EventKind::meets_upper: return c.upper - now.configuration[c.position];
  }
  return 0.0;
}

/// The first event if all rates stay constant.
std::optional<Event> EventSearch::earliest(const Setting& setting) const {
  std::optional<Event> found;
  double first = 2.0;
  const auto consider = [&](const Event& event) {
    const double before = distance(event, setting.from, setting.from);
    const double after = distance(event, setting.from, step_.after());
    if (!(before > 0.0 && after < 0.0)) return;
    const double share = before / (before - after);
    if (share >= first) return;
    first = share;
    found = event;
  };
  for (std::size_t c = 0; c < machine_.coordinates().size(); ++c) {
    if (setting.stopped[c] != Contact::free || machine_.coordinates()[c].imposed) continue;
    if (step_.rubs(c)) consider({c, EventKind::rests});
    if (machine_.coordinates()[c].ball) continue;
    consider({c, EventKind::meets_lower});
    consider({c, EventKind::meets_upper});
  }
  return found;
}

/// By regula falsi in the Illinois variant (M. Dowell, P. Jarratt, BIT 11 (1971) 168-174).
double EventSearch::locate(const Event& event, const Setting& setting, double length) {
  double low = 0.0, high = length, length_now = length;
  double at_low = distance(event, setting.from, setting.from), at_high = distance(event, setting.from, step_.after());
  const double told = kTold * fastest(setting.from) * (event.kind == EventKind::rests ? 1.0 : length);
  const double small = std::max(kLocated * at_low, told);
  for (int trial = 0; trial < kMostTrials && high - low > kLocated * length; ++trial) {
    length_now = std::max(high - at_high * (high - low) / (at_high - at_low), kLocated * length);
    take(setting, length_now);
    const double now = distance(event, setting.from, step_.after());
    if (std::abs(now) <= small) break;
    if (now < 0.0) {
      high = length_now;
      at_high = now;
      at_low *= 0.5;
    } else {
      low = length_now;
      at_low = now;
      at_high *= 0.5;
    }
  }
  return length_now;
}

std::optional<EventSearch::Found> EventSearch::first(const Setting& setting, double length) {
  std::optional<Found> found;
  // Repeats while an earlier event is found.
  for (std::optional<Event> event = earliest(setting); event; event = earliest(setting)) {
    if (found && found->event.coordinate == event->coordinate && found->event.kind == event->kind) break;
    const double shorter = locate(*event, setting, found ? found->length : length);
    if (found && shorter >= (1.0 - kSameMoment) * found->length) {  // two events at once would alternate for ever
      take(setting, found->length);
      break;
    }
    found = Found{*event, shorter};
  }
  return found;
}

}  // namespace lacuna::articulated
