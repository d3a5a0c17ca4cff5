#include "junctions.h"

#include <lacuna/cylinder.h>

#include <algorithm>
#include <optional>

namespace lacuna {
namespace {

using Eigen::Vector3d;

constexpr double kMeets = 1e-6;  // m

std::optional<std::size_t> index_of(const RobotSpec& robot, const std::string& name) {
  const auto found =
      std::find_if(robot.bodies.begin(), robot.bodies.end(), [&](const BodySpec& body) { return body.name == name; });
  if (found == robot.bodies.end()) return std::nullopt;
  return static_cast<std::size_t>(found - robot.bodies.begin());
}

/// The end of the body at a place in the world: 0 its tail, 1 its head; none: neither.
std::optional<std::size_t> end_at(const BodySpec& body, const Vector3d& place) {
  if (body.shapes.empty()) return std::nullopt;
  const CylinderEnds ends = cylinder_ends(body, body.shapes.front());
  if ((place - ends.tail).norm() < kMeets) return 0;
  if ((place - ends.head).norm() < kMeets) return 1;
  return std::nullopt;
}

/// Sets of equal numbers.
class Sets {
 public:
  explicit Sets(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) parent_.push_back(i);
  }
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.size() - 1;
  }
  std::size_t find(std::size_t one) const {
    while (parent_[one] != one) one = parent_[one];
    return one;
  }
  /// The smallest number stands for all.
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<std::size_t> junctions(const RobotSpec& robot) {
  const std::size_t ends = 2 * robot.bodies.size();
  Sets sets(ends + robot.bodies.size());  // the last: places on bodies that are not ends
  for (const JointSpec& joint : robot.joints) {
    const auto parent = index_of(robot, joint.parent), child = index_of(robot, joint.child);
    if (!child) continue;
    const auto place_on = [&](std::size_t body) {
      const auto end = end_at(robot.bodies[body], joint.anchor);
      return end ? 2 * body + *end : ends + body;
    };
    const std::size_t on_child = place_on(*child);
    sets.join(on_child, parent ? place_on(*parent) : sets.add());
  }
  std::vector<std::size_t> places;
  for (std::size_t end = 0; end < ends + robot.bodies.size(); ++end) places.push_back(sets.find(end));
  return places;
}

}  // namespace lacuna
