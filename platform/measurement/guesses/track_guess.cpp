#include "measurement/guesses/track_guess.h"

#include "foundation/unit.h"
#include "measurement/names/column_words.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace lacuna {
namespace {

constexpr std::size_t kFewestPoints = 20;
constexpr double kLargestScatter = 0.02;  ///< of the radius
constexpr double kSmallestArc = 0.1;      ///< rad, of a point that goes to and fro
constexpr double kWholeWay = 5.0;         ///< rad, of a point that need not return
constexpr int kFewestReturns = 2;         ///< a thrown ball has one at most
constexpr double kStepBack = 0.25;        ///< of the arc: the least return after a change of direction

struct Points {
  Eigen::VectorXd x, y;  ///< m
};

struct Circle {
  double x = 0.0, y = 0.0, radius = 0.0;  ///< m
  double scatter = 0.0;                   ///< m, root mean square
};

Points points_of(const std::vector<double>& x, const std::vector<double>& y, double to_si) {
  std::vector<double> kept_x, kept_y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    kept_x.push_back(x[i] * to_si);
    kept_y.push_back(y[i] * to_si);
  }
  const auto size = static_cast<Eigen::Index>(kept_x.size());
  return {Eigen::Map<Eigen::VectorXd>(kept_x.data(), size), Eigen::Map<Eigen::VectorXd>(kept_y.data(), size)};
}

/// The least-squares circle: first by its equation, which is linear, then by distances.
Circle circle_through(const Points& points) {
  const double x0 = points.x.mean(), y0 = points.y.mean();
  const Eigen::ArrayXd x = points.x.array() - x0, y = points.y.array() - y0;
  Eigen::MatrixXd columns(x.size(), 3);
  columns << 2.0 * x.matrix(), 2.0 * y.matrix(), Eigen::VectorXd::Ones(x.size());
  const Eigen::Vector3d solved = columns.colPivHouseholderQr().solve((x.square() + y.square()).matrix());
  Circle circle{solved(0), solved(1), std::sqrt(std::max(solved(2) + solved.head<2>().squaredNorm(), 0.0)), 0.0};
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::ArrayXd dx = x - circle.x, dy = y - circle.y, away = (dx.square() + dy.square()).sqrt();
    const Eigen::ArrayXd residual = away - circle.radius;
    circle.scatter = std::sqrt(residual.square().mean());
    columns << (-dx / away).matrix(), (-dy / away).matrix(), -Eigen::VectorXd::Ones(x.size());
    const Eigen::Vector3d change = columns.colPivHouseholderQr().solve((-residual).matrix());
    if (!change.allFinite()) break;
    circle.x += change(0);
    circle.y += change(1);
    circle.radius += change(2);
  }
  circle.x += x0;
  circle.y += y0;
  return circle;
}

/// Angles on the circle, without jumps.
std::vector<double> angles_on(const Circle& circle, const Points& points) {
  std::vector<double> angles;
  for (Eigen::Index i = 0; i < points.x.size(); ++i) {
    const double angle = std::atan2(points.y(i) - circle.y, points.x(i) - circle.x);
    angles.push_back(angles.empty() ? angle : angles.back() + std::remainder(angle - angles.back(), 2.0 * M_PI));
  }
  return angles;
}

int count_returns(const std::vector<double>& angles, double enough) {
  int returns = 0, direction = 0;
  double turned_at = angles.front();
  for (const double angle : angles) {
    if (direction != 0 && direction * (angle - turned_at) > 0.0) turned_at = angle;
    if (direction != 0 && direction * (turned_at - angle) > enough) {
      ++returns;
      direction = -direction;
      turned_at = angle;
    }
    if (direction == 0 && std::abs(angle - turned_at) > enough) {
      direction = angle > turned_at ? 1 : -1;
      turned_at = angle;
    }
  }
  return returns;
}

/// Whether a point moves like one on a hinged body.
std::optional<Circle> hinged_circle(const Points& points) {
  if (static_cast<std::size_t>(points.x.size()) < kFewestPoints) return std::nullopt;
  const Circle circle = circle_through(points);
  if (!std::isfinite(circle.radius) || !(circle.scatter < kLargestScatter * circle.radius)) return std::nullopt;
  const std::vector<double> angles = angles_on(circle, points);
  const auto [lowest, highest] = std::ranges::minmax_element(angles);
  const double arc = *highest - *lowest;
  const bool comes_back = arc > kSmallestArc && count_returns(angles, kStepBack * arc) >= kFewestReturns;
  if (!comes_back && arc < kWholeWay) return std::nullopt;
  // On a straight line the scatter is small compared with the radius, too, but not with the arc's height.
  const double height = circle.radius * (1.0 - std::cos(std::min(0.5 * arc, M_PI)));
  return circle.scatter < 0.25 * height ? std::optional(circle) : std::nullopt;
}

/// The name without the word "x" or "y"; nothing where it does not have that word.
std::optional<std::vector<std::string>> without_word(const std::string& name, const std::string& word) {
  std::vector<std::string> words = words_of(name);
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) return std::nullopt;
  words.erase(found);
  return words;
}

std::optional<double> metres_per_unit(const GuessedColumn& x, const GuessedColumn& y) {
  if (x.unit != y.unit || x.role != ColumnRole::position || y.role != ColumnRole::position) return std::nullopt;
  const std::optional<Unit> unit = parse_unit(x.unit.empty() ? "m" : x.unit);
  return unit && unit->same_dimension(*parse_unit("m")) ? std::optional(unit->to_si) : std::nullopt;
}

bool has_all(const std::vector<std::string>& words, const std::vector<std::string>& wanted) {
  return std::ranges::all_of(wanted,
                             [&](const std::string& word) { return std::ranges::find(words, word) != words.end(); });
}

/// Components of the point's velocity are not the joint's velocity.
void leave_out_velocities(const std::vector<std::string>& rest, std::vector<GuessedColumn>& columns) {
  for (GuessedColumn& column : columns) {
    if (column.role != ColumnRole::velocity) continue;
    for (const char* component : {"x", "y"})
      if (std::vector<std::string> words = without_word(column.name, component).value_or(std::vector<std::string>{});
          !words.empty() && has_all(words, rest))
        column.role = ColumnRole::other;
    if (column.role == ColumnRole::other) column.reason = "a component of the point's velocity, not of the joint's";
  }
}

}  // namespace

void settle_tracks(const FileSample& sample, std::vector<GuessedColumn>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const auto of_x = without_word(columns[i].name, "x"), of_y = without_word(columns[j].name, "y");
      if (!of_x || of_x != of_y || columns[i].passed_over) continue;
      const std::optional<double> to_si = metres_per_unit(columns[i], columns[j]);
      if (!to_si) continue;
      const std::optional<Circle> circle = hinged_circle(points_of(sample.columns[i], sample.columns[j], *to_si));
      if (!circle) continue;
      if (columns[i].unit.empty()) columns[i].unit = "m";
      columns[i].track = GuessedTrack{columns[j].name, circle->x, circle->y, circle->radius, circle->scatter};
      columns[i].reason = "x and y move on a circle";
      columns[j].role = ColumnRole::other;
      columns[j].reason = fmt::format("the angle is computed from it and `{}`", columns[i].name);
      columns[j].in_track = true;
      leave_out_velocities(*of_x, columns);
    }
}

}  // namespace lacuna
