#include "simulation/ode/articulation.h"

#include <algorithm>

namespace lacuna::ode {
namespace {

/// What constraints may yield, of the motion that they prevent: what is neglected is its square.
constexpr double kMostYielding = 1e-4;

bool has(unsigned set, std::size_t element) { return (set >> element & 1U) != 0; }

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
  return robot.joints.size() <= kMost && yielding * largest_inertia(robot, bodies) < kMostYielding;
}

Articulation::Articulation(const RobotSpec& robot, const simulation::JointTree& tree, const Bodies& bodies,
                           dWorldID world, double step, std::size_t laws)
    : world_(world),
      settings_{.step = step, .correction = dWorldGetERP(world) / step, .compliance = dWorldGetCFM(world) / step},
      coordinates_(static_cast<int>(robot.joints.size()), step, laws) {
  for (PassedOn& passed : alone_) passed.held.fill(Spatial::zero());
  links_.reserve(robot.joints.size());
  places_.reserve(robot.joints.size());
  for (const int joint : tree.outward) add_link(robot, tree, bodies, static_cast<std::size_t>(joint));
}

void Articulation::add_link(const RobotSpec& robot, const simulation::JointTree& tree, const Bodies& bodies,
                            std::size_t joint) {
  const int child = tree.child[joint], parent = tree.parent[joint];
  const SteppedBody body(bodies.id(child), bodies.pose(child), robot.bodies[static_cast<std::size_t>(child)]);
  const std::size_t link = links_.size();
  links_.emplace_back(body, robot.joints[joint], bodies.pose(parent), parent < 0);
  Place& place = places_.emplace_back(Place{.body = child, .coordinate = tree.first_coordinate[joint]});
  for (std::size_t i = 0; i < link; ++i)
    if (parent >= 0 && places_[i].body == parent) place.parent = static_cast<int>(i);
  place.moved = place.strained = 1U << link;
  for (int i = place.parent; i >= 0; i = places_[static_cast<std::size_t>(i)].parent) {
    Place& holder = places_[static_cast<std::size_t>(i)];
    holder.moved |= 1U << link;
    holder.strained |= 1U << link;
    place.strained |= 1U << static_cast<unsigned>(i);
  }
  all_ |= 1U << link;
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
    const int c = places_[i].coordinate;
    coordinates_.offset[c] = links_[i].coordinate_velocity(links_[i].correction());
    coordinates_.push[c] = settings_.compliance * product(alone_[i].held, balance_.held) - balance_.share[i];
    for (std::size_t j = i; j < links_.size(); ++j) {
      const int d = places_[j].coordinate;
      coordinates_.inertia(c, d) = coordinates_.inertia(d, c) =
          alone_[j].share[i] - settings_.compliance * product(alone_[i].held, alone_[j].held);
    }
  }
}

double Articulation::product(const PerJoint& a, const PerJoint& b) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < links_.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

void Articulation::move() {
  PerJoint velocity;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Spatial held = balance_.held[i];
    for (std::size_t j = 0; j < links_.size(); ++j) {
      const int c = places_[j].coordinate;
      held += (velocity_[c] - coordinates_.offset[c]) * alone_[j].held[i];
    }
    const Spatial relative = links_[i].at_coordinate_velocity(velocity_[places_[i].coordinate],
                                                              links_[i].correction() - settings_.compliance * held);
    const int parent = places_[i].parent;
    velocity[i] =
        links_[i].carried(parent < 0 ? Spatial::zero() : velocity[static_cast<std::size_t>(parent)], relative);
  }
  // Not before: what holds a body is looked at where it was.
  for (std::size_t i = 0; i < links_.size(); ++i) links_[i].move(velocity[i], settings_.step);
}

}  // namespace lacuna::ode
