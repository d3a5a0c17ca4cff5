#include "fitting/starts/free_reading.h"

#include "fitting/numerics/local_polynomial.h"
#include "foundation/address.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr Eigen::Index kReach = 25;  ///< readings to either side that a polynomial may need
constexpr int kDegree = 2;

Vector3d rotation_vector(const Quaterniond& turn) {
  const Eigen::AngleAxisd around(turn.w() < 0.0 ? Quaterniond(-turn.coeffs()) : turn);
  return around.angle() * around.axis();
}

Quaterniond turn_by(const Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0.0 ? Quaterniond(Eigen::AngleAxisd(angle, vector / angle)) : Quaterniond::Identity();
}

/// The first channel of the body's sensor of that kind, if all of its channels are measured.
std::optional<Eigen::Index> column_of(const RobotSpec& robot, const std::string& body, SensorKind kind,
                                      const TimeSeries& measured) {
  for (const SensorSpec& sensor : robot.sensors) {
    if (sensor.kind != kind || sensor.element != body || sensor.scale != 1.0 || sensor.offset != 0.0) continue;
    const std::vector<Channel> channels = sensor_channels(robot, sensor);
    const auto first =
        std::search(measured.channels.begin(), measured.channels.end(), channels.begin(), channels.end());
    if (first != measured.channels.end()) return first - measured.channels.begin();
  }
  return std::nullopt;
}

}  // namespace

FreeReading::FreeReading(const RobotSpec& robot, const JointSpec& joint, const TimeSeries& measured,
                         const std::vector<double>& deviations)
    : place_(column_of(robot, joint.child, SensorKind::body_position, measured)),
      turn_(column_of(robot, joint.child, SensorKind::body_orientation, measured)) {
  const auto body = std::find_if(robot.bodies.begin(), robot.bodies.end(),
                                 [&](const BodySpec& one) { return one.name == joint.child; });
  com_ = body->com;
  zero_turn_ = body->orientation.normalized();
  zero_place_ = body->position + zero_turn_ * com_;
  if (place_) place_noise_ = deviations[static_cast<std::size_t>(*place_)];
  if (turn_) turn_noise_ = 2.0 * deviations[static_cast<std::size_t>(*turn_)];  // of an angle
  if (!turn_ && !com_.isZero(0.0)) place_.reset();  // the position of the centre depends on the orientation of the body
}

bool FreeReading::tells(int coordinate) const { return coordinate < 3 ? place_.has_value() : turn_.has_value(); }

std::optional<Quaterniond> FreeReading::turn(const TimeSeries& measured, Eigen::Index row) const {
  if (!turn_) return Quaterniond::Identity();
  const auto q = measured.samples.row(row).segment(*turn_, 4);
  if (!q.allFinite() || q.norm() == 0.0) return std::nullopt;
  return Quaterniond(q(0), q(1), q(2), q(3)).normalized();
}

/// Displacement of the centre of mass, and turn from `about`, of the readings in a range.
TimeSeries FreeReading::nearby(const TimeSeries& measured, std::pair<Eigen::Index, Eigen::Index> range,
                               const Quaterniond& about) const {
  TimeSeries near;
  near.channels.resize(6);
  near.times = measured.times.segment(range.first, range.second - range.first);
  near.samples.resize(near.times.size(), 6);
  near.samples.setConstant(std::nan(""));
  for (Eigen::Index i = 0; i < near.times.size(); ++i) {
    const std::optional<Quaterniond> turned = turn(measured, range.first + i);
    if (!turned) continue;
    if (place_) {
      const Vector3d origin = measured.samples.row(range.first + i).segment(*place_, 3).transpose();
      near.samples.row(i).head(3) = (origin + *turned * com_ - zero_place_).transpose();
    }
    if (turn_) near.samples.row(i).tail(3) = rotation_vector(*turned * about.conjugate()).transpose();
  }
  return near;
}

std::array<std::optional<CoordinateReading>, 6> FreeReading::at(const TimeSeries& measured,
                                                                std::pair<Eigen::Index, Eigen::Index> range,
                                                                Eigen::Index sample, double window) const {
  std::array<std::optional<CoordinateReading>, 6> readings;
  const std::pair near{std::max(range.first, sample - kReach), std::min(range.second, sample + kReach + 1)};
  std::optional<Quaterniond> about;
  for (Eigen::Index row = sample; row < near.second && !about; ++row) about = turn(measured, row);
  if (!about) return readings;
  const TimeSeries series = nearby(measured, near, *about);
  std::array<LocalPolynomial, 6> lines;
  for (int c = 0; c < 6; ++c) {
    if (!tells(c)) continue;
    lines[static_cast<std::size_t>(c)] = fit_local_polynomial(series, c, {0, series.times.size()}, sample - near.first,
                                                              kDegree, window, c < 3 ? place_noise_ : turn_noise_);
  }
  const Vector3d off(lines[3].value, lines[4].value, lines[5].value);
  const Vector3d turned = rotation_vector(turn_by(off) * *about * zero_turn_.conjugate());
  for (int c = 0; c < 6; ++c) {
    const LocalPolynomial& line = lines[static_cast<std::size_t>(c)];
    if (!tells(c) || line.points < 2) continue;
    readings[static_cast<std::size_t>(c)] =
        CoordinateReading{c < 3 ? line.value : turned[c - 3], line.slope, line.value_deviation, line.slope_deviation};
  }
  return readings;
}

}  // namespace lacuna
