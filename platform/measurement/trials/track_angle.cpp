#include "measurement/trials/track_angle.h"

#include "foundation/unit.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

/// Replaces x; angles continue from turn to turn.
void make_angles(const std::vector<double>& y, const PlannedColumn& sensor, std::vector<double>& x) {
  const TrackedPoint& track = sensor.mapping->track;
  const double to_si = parse_unit(sensor.mapping->unit)->to_si;
  double before = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] * to_si - track.pivot[0], dy = y[i] * to_si - track.pivot[1];
    if (!std::isfinite(dx) || !std::isfinite(dy)) {
      x[i] = std::numeric_limits<double>::quiet_NaN();
    } else if (sensor.channel.unit == "rad") {
      before += std::remainder(std::atan2(dy, dx) - track.zero - before, 2.0 * M_PI);
      x[i] = before;
    } else {
      x[i] = std::hypot(dx, dy);
    }
  }
}

}  // namespace

void make_angles_of_tracks(const RecordingPlan& plan, ReadTable& read) {
  const std::size_t others = columns_of(plan).size() + plan.switches.size();
  std::size_t next = others;
  for (std::size_t c = 0; c < plan.sensors.size(); ++c) {
    const PlannedColumn& sensor = plan.sensors[c];
    if (sensor.mapping->track.other.empty() || next >= read.table.columns.size()) continue;
    std::vector<double>& x = read.table.columns[c];
    const std::vector<double>& y = read.table.columns[next++];
    if (x.empty() && y.empty()) continue;
    if (x.size() != y.size()) {
      read.report.problem("track", 0, [&] {
        return fmt::format(
            "has only one of the columns `{}` and `{}`, x and y of a tracked point; they must be in one "
            "file",
            sensor.mapping->column, sensor.mapping->track.other);
      });
      continue;
    }
    make_angles(y, sensor, x);
  }
  read.table.columns.resize(std::min(others, read.table.columns.size()));
}

}  // namespace lacuna
