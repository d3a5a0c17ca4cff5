#include "shapes/trilateration.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kOneHeight = 1e-9;  // m

struct BeaconRange {
  Eigen::Vector3d beacon;
  double metres;
};

/// The mean over trials of a channel's first sample; NaN where none has it.
double first_reading(const std::string& channel, const std::vector<Trial>& trials) {
  double sum = 0.0;
  int count = 0;
  for (const Trial& trial : trials)
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c)
      if (trial.measured.channels[c].name == channel && trial.measured.samples.rows() > 0) {
        sum += trial.measured.samples(0, static_cast<Eigen::Index>(c));
        ++count;
      }
  return sum / count;
}

/// |p − b|² − |p − b₀|² is linear in p.
std::optional<Eigen::Vector3d> centre_from(const std::vector<BeaconRange>& ranges) {
  if (ranges.size() < 3) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(ranges.size()) - 1;
  Eigen::MatrixX2d differences(rows, 2);
  Eigen::VectorXd right(rows);
  const BeaconRange& first = ranges.front();
  for (Eigen::Index i = 0; i < rows; ++i) {
    const BeaconRange& other = ranges[static_cast<std::size_t>(i) + 1];
    if (std::abs(other.beacon.z() - first.beacon.z()) > kOneHeight) return std::nullopt;
    differences.row(i) = 2.0 * (other.beacon - first.beacon).head<2>().transpose();
    right(i) = first.metres * first.metres - other.metres * other.metres + other.beacon.head<2>().squaredNorm() -
               first.beacon.head<2>().squaredNorm();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX2d> solver(differences);
  if (solver.rank() < 2) return std::nullopt;
  const Eigen::Vector2d place = solver.solve(right);
  double height = 0.0;
  for (const BeaconRange& range : ranges)
    height += range.metres * range.metres - (place - range.beacon.head<2>()).squaredNorm();
  height = std::sqrt(std::max(0.0, height / static_cast<double>(ranges.size())));
  return Eigen::Vector3d(place.x(), place.y(), first.beacon.z() + height);
}

}  // namespace

std::optional<Eigen::MatrixX3d> trilaterated_centres(const RobotSpec& robot, const std::vector<Trial>& trials) {
  Eigen::MatrixX3d centres(static_cast<Eigen::Index>(robot.bodies.size()), 3);
  for (std::size_t body = 0; body < robot.bodies.size(); ++body) {
    std::vector<BeaconRange> ranges;
    for (const SensorSpec& sensor : robot.sensors)
      if (sensor.kind == SensorKind::beacon_range && sensor.element == robot.bodies[body].name)
        if (const double metres = first_reading(sensor.name, trials); std::isfinite(metres))
          ranges.push_back({sensor.beacon, metres});
    const std::optional<Eigen::Vector3d> centre = centre_from(ranges);
    if (!centre) return std::nullopt;
    centres.row(static_cast<Eigen::Index>(body)) = centre->transpose();
  }
  return centres;
}

}  // namespace lacuna
