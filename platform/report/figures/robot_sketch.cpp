#include "report/figures/robot_sketch.h"

#include <lacuna/cylinder.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kAzimuth = -62.0 * std::numbers::pi / 180.0, kElevation = 38.0 * std::numbers::pi / 180.0;
constexpr double kPixelsPerMetre = 34.0, kHalfGrid = 2.0, kThinnestStick = 1.5;  // the grid in m, the stick in px
constexpr double kReachAcross = 140.0, kReachUp = 130.0;  // px from the origin; what reaches farther is drawn smaller
/// Okabe and Ito 2008.
constexpr std::array<const char*, 7> kPartColours = {"#3A3A3A", "#0072B2", "#56B4E9", "#D55E00",
                                                     "#009E73", "#CC79A7", "#E69F00"};

const Vector3d& to_viewer() {
  static const Vector3d direction(std::cos(kAzimuth) * std::cos(kElevation), std::sin(kAzimuth) * std::cos(kElevation),
                                  std::sin(kElevation));
  return direction;
}

/// Right and down, px of a drawing that is not made smaller.
Vector2d projected(const Vector3d& point) {
  const Vector3d right(-std::sin(kAzimuth), std::cos(kAzimuth), 0.0);
  const Vector3d up = to_viewer().cross(right);
  return kPixelsPerMetre * Vector2d(point.dot(right), -point.dot(up));
}

}  // namespace

const char* part_colour(std::size_t part) { return kPartColours[part % kPartColours.size()]; }

std::string svg_line(const Vector2d& from, const Vector2d& to, double width, const char* colour, double opacity) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
      "stroke-opacity=\"{}\"/>\n",
      from.x(), from.y(), to.x(), to.y(), colour, width, opacity);
}

std::string svg_dot(const Vector2d& place) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", place.x(), place.y(), "#9A9A9A");
}

RobotSketch::RobotSketch(const RobotSpec& robot) : robot_(robot) {
  for (std::size_t i = 0; i < robot.bodies.size(); ++i)
    if (!robot.bodies[i].shapes.empty()) add_part(robot.bodies[i], part_colour(i));
  // The farthest first; what is below the ground behind all that is above it.
  std::stable_sort(sticks_.begin(), sticks_.end(), [](const Stick& a, const Stick& b) {
    if (a.below != b.below) return a.below;
    return (a.from + a.to).dot(to_viewer()) < (b.from + b.to).dot(to_viewer());
  });
  for (const double x : {-kHalfGrid, kHalfGrid})
    for (const double y : {-kHalfGrid, kHalfGrid}) hold({x, y, 0.0}, 0.0);
  for (const SensorSpec& sensor : robot.sensors)
    if (sensor.kind == SensorKind::beacon_range) hold(sensor.beacon, 0.0);
  for (const Stick& stick : sticks_)
    for (const Vector3d& end : {stick.from, stick.to}) hold(end, 0.5 * stick.width);
  const Vector2d reach = box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs());
  scale_ = std::min({1.0, kReachAcross / reach.x(), kReachUp / reach.y()});
}

std::string RobotSketch::svg() const {
  std::string text = ground();
  for (const Stick& stick : sticks_) {
    const Vector2d from = scale_ * projected(stick.from), to = scale_ * projected(stick.to);
    const double width = std::max(kThinnestStick, scale_ * stick.width);
    text += svg_line(from, to, width + 1.5, "#FFFFFF", 1.0);
    text += svg_line(from, to, width, stick.colour, stick.below ? kBelowGround : 1.0);
  }
  return text;
}

/// Cut where it passes through the ground.
void RobotSketch::add_part(const BodySpec& body, const char* colour) {
  const ShapeSpec& shape = body.shapes.front();
  const auto [tail, head] = cylinder_ends(body, shape);
  const double width = 2.0 * kPixelsPerMetre * shape.size.x();
  if (tail.z() * head.z() >= 0.0) {
    add_stretch(tail, head, width, colour);
    return;
  }
  const Vector3d surface = tail + (head - tail) * (tail.z() / (tail.z() - head.z()));
  add_stretch(tail, surface, width, colour);
  add_stretch(surface, head, width, colour);
}

void RobotSketch::add_stretch(const Vector3d& from, const Vector3d& to, double width, const char* colour) {
  sticks_.push_back({from, to, width, colour, 0.5 * (from.z() + to.z()) < 0.0});
}

void RobotSketch::hold(const Vector3d& place, double about) {
  const Vector2d at = projected(place), margin(about, about);
  box_.extend(AlignedBox2d(at - margin, at + margin));
}

std::string RobotSketch::ground() const {
  std::string text;
  const auto grid_line = [&](const Vector3d& from, const Vector3d& to) {
    text += svg_line(scale_ * projected(from), scale_ * projected(to), 0.7, "#D8D8D8", 1.0);
  };
  for (double at = -kHalfGrid; at <= kHalfGrid; at += 1.0) {
    grid_line({at, -kHalfGrid, 0.0}, {at, kHalfGrid, 0.0});
    grid_line({-kHalfGrid, at, 0.0}, {kHalfGrid, at, 0.0});
  }
  for (const SensorSpec& sensor : robot_.sensors)
    if (sensor.kind == SensorKind::beacon_range) text += svg_dot(scale_ * projected(sensor.beacon));
  return text;
}

}  // namespace lacuna
