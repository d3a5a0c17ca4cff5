#include "simulation/ode/articulation.h"

#include <algorithm>

namespace lacuna::ode {
namespace {

/// What constraints may yield, of the motion that they prevent: what is neglected is its square.
constexpr double kMostYielding = 1e-5;

bool has(unsigned set, std::size_t element) { return (set >> element & 1U) != 0; }

bool hinge_or_slider(const JointSpec& joint) {
  return joint.kind == JointKind::hinge || joint.kind == JointKind::slider;
}

/// The most that a joint anywhere on the robot could have to move: a mass or a moment of inertia.
double largest_inertia(const RobotSpec& robot, const Bodies& bodies) {
  double mass = 0.0, largest = 0.0;
  for (const JointSpec& joint : robot.joints) {
    double inertia = 0.0;
    for (std::size_t b = 0; b < robot.bodies.size(); ++b) {
      const BodySpec& body = robot.bodies[b];
      inertia += body.inertia.xx + body.inertia.yy + body.inertia.zz +
                 body.mass * (bodies.pose(static_cast<int>(b)).x() - joint.anchor).squaredNorm();
    }
    largest = std::max(largest, inertia);
  }
  for (const BodySpec& body : robot.bodies) mass += body.mass;
  return std::max(mass, largest);
}

}  // namespace

bool Articulation::fits(const RobotSpec& robot, const Bodies& bodies, double yielding) {
  const std::size_t count = robot.joints.size();
  if (count < 1 || count > kMost || robot.bodies.size() != count) return false;
  if (!std::all_of(robot.joints.begin(), robot.joints.end(), hinge_or_slider)) return false;
  const bool shaped =
      std::any_of(robot.bodies.begin(), robot.bodies.end(), [](const BodySpec& body) { return !body.shapes.empty(); });
  return !(robot.contact.ground && shaped) && yielding * largest_inertia(robot, bodies) < kMostYielding;
}

void Articulation::prepare(const RobotSpec& robot, const simulation::JointTree& tree, const Bodies& bodies,
                           dWorldID world, double step, std::size_t laws) {
  world_ = world;
  erp_ = dWorldGetERP(world);
  cfm_ = dWorldGetCFM(world);
  settings_ = {.step = step, .correction = erp_ / step, .compliance = cfm_ / step};
  links_.clear();
  places_.clear();
  stops_.assign(robot.joints.size(), {});
  std::vector<int> link_of(robot.bodies.size(), -1);
  for (const int j : tree.outward) {
    const auto joint = static_cast<std::size_t>(j), link = links_.size();
    const int child = tree.child[joint], parent = tree.parent[joint];
    links_.emplace_back(robot.bodies[static_cast<std::size_t>(child)], robot.joints[joint], bodies.id(child),
                        bodies.pose(child), bodies.id(parent), bodies.pose(parent));
    link_of[static_cast<std::size_t>(child)] = static_cast<int>(link);
    const int holder = parent < 0 ? -1 : link_of[static_cast<std::size_t>(parent)];
    Place& place = places_.emplace_back(Place{.coordinate = tree.first_coordinate[joint], .parent = holder});
    for (int k = static_cast<int>(link); k >= 0; k = places_[static_cast<std::size_t>(k)].parent) {
      places_[static_cast<std::size_t>(k)].moved |= 1U << link;
      places_[static_cast<std::size_t>(k)].strained |= 1U << link;
      place.strained |= 1U << static_cast<unsigned>(k);
    }
    stops_[static_cast<std::size_t>(place.coordinate)] = {robot.joints[joint].lower, robot.joints[joint].upper};
  }
  all_ = (1U << links_.size()) - 1U;
  coordinates_.prepare(static_cast<int>(links_.size()), step, laws);
}

std::optional<CoordinateLaw> Articulation::stop(std::size_t coordinate, double position) const {
  const auto [lower, upper] = stops_[coordinate];
  const bool below = position <= lower;
  if (!below && position < upper) return std::nullopt;
  CoordinateLaw law{.target = settings_.correction * ((below ? lower : upper) - position),
                    .compliance = cfm_,
                    .coordinate = coordinate};
  if (lower != upper) (below ? law.lower : law.upper) = 0.0;
  return law;
}

std::span<const double> Articulation::advance(std::span<const CoordinateLaw> laws, std::span<const double> before) {
  dVector3 gravity;
  dWorldGetGravity(world_, gravity);
  settings_.gravity = MapVector(gravity);
  for (ArticulatedLink& link : links_) link.look(settings_);
  for (std::size_t joint = 0; joint < links_.size(); ++joint) move_alone(joint);
  balance();
  couple();
  std::copy(before.begin(), before.end(), velocity_.begin());
  coordinates_.settle(laws, velocity_);
  move();
  return {velocity_.data(), links_.size()};
}

/// What the joints pass on if one of them moves at velocity 1, and the others hold still.
void Articulation::move_alone(std::size_t joint) {
  PerJoint velocity, gained;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    gained[i] = Spatial::zero();
    if (!has(places_[joint].moved, i)) continue;
    velocity[i] =
        i == joint ? links_[i].along() : links_[i].carried(velocity[static_cast<std::size_t>(places_[i].parent)]);
    gained[i] = links_[i].momentum(velocity[i]);
  }
  pass_on(places_[joint].strained, gained, alone_[joint]);
}

/// What the joints pass on if all hold still, but for their drifts, against the momentum that the bodies would have.
void Articulation::balance() {
  PerJoint velocity, gained;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const int parent = places_[i].parent;
    velocity[i] = links_[i].carried(parent < 0 ? Spatial::zero() : velocity[static_cast<std::size_t>(parent)],
                                    links_[i].correction());
    gained[i] = links_[i].momentum(velocity[i]) - links_[i].own_momentum();
  }
  pass_on(all_, gained, balance_);
}

void Articulation::pass_on(unsigned strained, PerJoint& gained, PassedOn& passed) const {
  for (std::size_t i = links_.size(); i-- > 0;) {
    if (!has(strained, i)) continue;
    const ArticulatedLink& link = links_[i];
    const Spatial here = link.passed_on(gained[i]);
    passed.share[i] = link.share(here);
    passed.held[i] = link.rest(here);
    const int parent = places_[i].parent;
    if (parent >= 0) gained[static_cast<std::size_t>(parent)] += link.reaction(here);
  }
}

/// The coordinates' inertia and push; less of both, as the constraints yield.
void Articulation::couple() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const int row = places_[i].coordinate;
    coordinates_.offset[row] = links_[i].coordinate_velocity(links_[i].correction());
    coordinates_.push[row] = -balance_.share[i];
    for (std::size_t k = 0; k < links_.size(); ++k)
      if (has(places_[i].strained, k))
        coordinates_.push[row] += settings_.compliance * alone_[i].held[k].dot(balance_.held[k]);
    for (std::size_t j = i; j < links_.size(); ++j) {
      double inertia = has(places_[i].moved, j) ? alone_[j].share[i] : 0.0;
      for (std::size_t k = 0; k < links_.size(); ++k)
        if (has(places_[i].strained & places_[j].strained, k))
          inertia -= settings_.compliance * alone_[i].held[k].dot(alone_[j].held[k]);
      const int column = places_[j].coordinate;
      coordinates_.inertia(row, column) = coordinates_.inertia(column, row) = inertia;
    }
  }
}

void Articulation::move() {
  PerJoint velocity;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Spatial carried = balance_.held[i];
    for (std::size_t j = 0; j < links_.size(); ++j) {
      const int column = places_[j].coordinate;
      if (has(places_[j].strained, i)) carried += (velocity_[column] - coordinates_.offset[column]) * alone_[j].held[i];
    }
    const Spatial relative = links_[i].at_coordinate_velocity(velocity_[places_[i].coordinate],
                                                              links_[i].correction() - settings_.compliance * carried);
    const int parent = places_[i].parent;
    velocity[i] =
        links_[i].carried(parent < 0 ? Spatial::zero() : velocity[static_cast<std::size_t>(parent)], relative);
  }
  // Not before: what holds a body is looked at where it was.
  for (std::size_t i = 0; i < links_.size(); ++i) links_[i].move(velocity[i], settings_.step);
}

}  // namespace lacuna::ode
