#include "report/robot_drawing.h"

#include "report/not_written.h"

#include <lacuna/cylinder.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

namespace lacuna {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kAzimuth = -62.0 * std::numbers::pi / 180.0, kElevation = 38.0 * std::numbers::pi / 180.0;
constexpr double kCellWidth = 196.0, kCellHeight = 150.0, kLabelWidth = 170.0, kTop = 46.0, kCaption = 22.0;  // px
constexpr double kPixelsPerMetre = 34.0;
constexpr double kHalfGrid = 2.0;  // m
/// Okabe and Ito 2008.
constexpr std::array<const char*, 7> kPartColours = {"#3A3A3A", "#0072B2", "#56B4E9", "#D55E00",
                                                     "#009E73", "#CC79A7", "#E69F00"};

const Vector3d& to_viewer() {
  static const Vector3d direction(std::cos(kAzimuth) * std::cos(kElevation), std::sin(kAzimuth) * std::cos(kElevation),
                                  std::sin(kElevation));
  return direction;
}

/// Right and down, px.
Vector2d projected(const Vector3d& point) {
  const Vector3d right(-std::sin(kAzimuth), std::cos(kAzimuth), 0.0);
  const Vector3d up = to_viewer().cross(right);
  return kPixelsPerMetre * Vector2d(point.dot(right), -point.dot(up));
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return safe;
}

std::string line(const Vector3d& from, const Vector3d& to, double width, const std::string& colour, double opacity) {
  const Vector2d a = projected(from), b = projected(to);
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
      "stroke-opacity=\"{}\"/>\n",
      a.x(), a.y(), b.x(), b.y(), colour, width, opacity);
}

std::string dot(const Vector3d& place, double radius, const char* colour) {
  const Vector2d at = projected(place);
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", at.x(), at.y(), radius, colour);
}

std::string text_at(double x, double y, const std::string& text, int size) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-size=\"{}\">{}</text>\n", x, y, size, escaped(text));
}

std::string ground(const RobotSpec& robot) {
  std::string text;
  for (double at = -kHalfGrid; at <= kHalfGrid; at += 1.0) {
    text += line({at, -kHalfGrid, 0.0}, {at, kHalfGrid, 0.0}, 0.7, "#D8D8D8", 1.0);
    text += line({-kHalfGrid, at, 0.0}, {kHalfGrid, at, 0.0}, 0.7, "#D8D8D8", 1.0);
  }
  for (const SensorSpec& sensor : robot.sensors)
    if (sensor.kind == SensorKind::beacon_range) text += dot(sensor.beacon, 2.5, "#9A9A9A");
  return text;
}

/// A stretch of a part's axis.
struct Stick {
  Vector3d from, to;
  double width;  ///< px
  const char* colour;
  bool below;
};

void add_stretch(std::vector<Stick>& sticks, const Vector3d& from, const Vector3d& to, double width,
                 const char* colour) {
  sticks.push_back({from, to, width, colour, 0.5 * (from.z() + to.z()) < 0.0});
}

/// Parts, cut where they pass through the ground.
std::vector<Stick> sticks_of(const RobotSpec& robot) {
  std::vector<Stick> sticks;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const BodySpec& body = robot.bodies[i];
    if (body.shapes.empty()) continue;
    const ShapeSpec& shape = body.shapes.front();
    const auto [tail, head] = cylinder_ends(body, shape);
    const double width = 2.0 * kPixelsPerMetre * shape.size.x();
    const char* colour = kPartColours[i % kPartColours.size()];
    if (tail.z() * head.z() >= 0.0) {
      add_stretch(sticks, tail, head, width, colour);
      continue;
    }
    const Vector3d surface = tail + (head - tail) * (tail.z() / (tail.z() - head.z()));
    add_stretch(sticks, tail, surface, width, colour);
    add_stretch(sticks, surface, head, width, colour);
  }
  return sticks;
}

/// The farthest first; what is below the ground behind all that is above it.
std::string drawing_of(const RobotSpec& robot) {
  std::vector<Stick> sticks = sticks_of(robot);
  std::stable_sort(sticks.begin(), sticks.end(), [](const Stick& a, const Stick& b) {
    if (a.below != b.below) return a.below;
    return (a.from + a.to).dot(to_viewer()) < (b.from + b.to).dot(to_viewer());
  });
  std::string text = ground(robot);
  for (const Stick& stick : sticks) {
    text += line(stick.from, stick.to, stick.width + 1.5, "#FFFFFF", 1.0);
    text += line(stick.from, stick.to, stick.width, stick.colour, stick.below ? 0.3 : 1.0);
  }
  return text;
}

/// What reaches beyond a cell is cut off.
std::string cell(const DrawnRobot& drawn, double left, double top) {
  return text_at(left + 6.0, top + 15.0, drawn.caption, 12) +
         fmt::format(
             "<svg x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" "
             "viewBox=\"{:.0f} {:.0f} {:.0f} {:.0f}\">\n",
             left, top + kCaption, kCellWidth, kCellHeight - kCaption, -0.5 * kCellWidth,
             -0.6 * (kCellHeight - kCaption), kCellWidth, kCellHeight - kCaption) +
         drawing_of(drawn.robot) + "</svg>\n";
}

std::string picture_of(const std::string& title, const std::vector<RobotRow>& rows) {
  std::size_t columns = 0;
  for (const RobotRow& row : rows) columns = std::max(columns, row.robots.size());
  const double width = kLabelWidth + kCellWidth * static_cast<double>(columns);
  const double height = kTop + kCellHeight * static_cast<double>(rows.size());
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" fill=\"#3A3A3A\">\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#FFFFFF\"/>\n",
      width, height);
  text += text_at(12.0, 26.0, title, 15);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double top = kTop + kCellHeight * static_cast<double>(row);
    text += text_at(12.0, top + 0.55 * kCellHeight, rows[row].label, 13);
    for (std::size_t column = 0; column < rows[row].robots.size(); ++column)
      text += cell(rows[row].robots[column], kLabelWidth + kCellWidth * static_cast<double>(column), top);
  }
  return text + "</svg>\n";
}

}  // namespace

void write_robots_svg(const std::string& title, const std::vector<RobotRow>& rows, const std::filesystem::path& file) {
  const std::filesystem::path draft = file.string() + ".draft";
  if (!(std::ofstream(draft) << picture_of(title, rows) << std::flush)) {
    std::error_code ignored;
    std::filesystem::remove(draft, ignored);
    throw_not_written(file);
  }
  std::filesystem::rename(draft, file);
}

}  // namespace lacuna
