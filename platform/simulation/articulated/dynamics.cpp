#include "simulation/articulated/dynamics.h"

#include <algorithm>
#include <cmath>

namespace lacuna::articulated {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Matrix3d turn_about(const Vector3d& axis, double angle) { return AngleAxisd(angle, axis).toRotationMatrix(); }

Matrix3d turn_of(const double* quaternion) {
  return Quaterniond(quaternion[0], quaternion[1], quaternion[2], quaternion[3]).toRotationMatrix();
}

}  // namespace

Dynamics::Dynamics(const Tree& tree)
    : tree_(tree),
      lone_(is_lone()),
      displacements_(tree.links().size()),
      centres_(tree.links().size()),
      references_(tree.links().size()),
      inertias_(tree.links().size()),
      composites_(tree.links().size()),
      axes_(tree.dofs()),
      velocities_(tree.links().size()),
      accelerations_(tree.links().size()),
      forces_(tree.links().size()) {
  take_numbers();
}

bool Dynamics::is_lone() const {
  if (tree_.links().size() != 1) return false;
  const LinkKind kind = tree_.links().front().kind;
  return kind == LinkKind::hinge || kind == LinkKind::slider;
}

void Dynamics::take_numbers() {
  if (!lone_) return;
  const Link& link = tree_.links().front();
  const Vector3d arm = link.com - link.anchor;
  at_zero_ = link.mass * (arm - link.axes[0].dot(arm) * link.axes[0]);
  at_quarter_ = link.axes[0].cross(at_zero_);
  lone_inertia_ = link.mass;
  if (link.kind == LinkKind::hinge)
    lone_inertia_ = link.axes[0].dot(link.inertia * link.axes[0]) + link.mass * link.axes[0].cross(arm).squaredNorm();
}

void Dynamics::place(std::span<const double> configuration, bool with_bodies) {
  only_coordinate_ = lone_ && !with_bodies;
  if (only_coordinate_) {
    coordinate_ = configuration[0];
    return;
  }
  for (std::size_t i = 0; i < tree_.links().size(); ++i)
    place_link(i, configuration.data() + tree_.links()[i].position);
}

void Dynamics::set_axis(int dof, const Vector3d& axis, const Vector3d& from_reference) {
  axes_[static_cast<std::size_t>(dof)] = {axis, from_reference.cross(axis)};
}

void Dynamics::place_link(std::size_t index, const double* q) {
  static const Displacement kStill;
  const Link& link = tree_.links()[index];
  const Displacement& parent = link.parent < 0 ? kStill : displacements_[static_cast<std::size_t>(link.parent)];
  Displacement& here = displacements_[index];
  const Vector3d pivot = link.kind == LinkKind::floating ? Vector3d(q[0], q[1], q[2]) : parent.moved(link.anchor);
  if (link.parent < 0) references_[index] = pivot;
  const Vector3d arm = from_reference(index, pivot);
  switch (link.kind) {
    case LinkKind::hinge:
      here.turn = parent.turn * turn_about(link.axes[0], q[0]);
      set_axis(link.dof, parent.turn * link.axes[0], arm);
      break;
    case LinkKind::slider: {
      const Vector3d axis = parent.turn * link.axes[0];
      here.turn = parent.turn;
      here.shift = parent.shift + q[0] * axis;
      axes_[static_cast<std::size_t>(link.dof)] = {Vector3d::Zero(), axis};
      break;
    }
    case LinkKind::universal: {
      const Matrix3d between = parent.turn * turn_about(link.axes[0], q[0]);
      here.turn = between * turn_about(link.axes[1], q[1]);
      set_axis(link.dof, parent.turn * link.axes[0], arm);
      set_axis(link.dof + 1, between * link.axes[1], arm);
      break;
    }
    case LinkKind::ball: {
      const Matrix3d frame = parent.turn * link.parent_frame;
      here.turn = frame * turn_of(q) * link.parent_frame.transpose();
      for (int i = 0; i < 3; ++i) set_axis(link.dof + i, frame.col(i), arm);
      break;
    }
    case LinkKind::fixed: here = parent; break;
    case LinkKind::floating:
      here.turn = turn_of(q + 3);
      for (int i = 0; i < 3; ++i) {
        axes_[nth(link.dof, i)] = {Vector3d::Zero(), Vector3d::Unit(i)};
        set_axis(link.dof + 3 + i, Vector3d::Unit(i), arm);
      }
      break;
  }
  if (link.kind == LinkKind::floating)
    here.shift = pivot - here.turn * link.com;
  else if (link.kind != LinkKind::slider && link.kind != LinkKind::fixed)
    here.shift = pivot - here.turn * link.anchor;
  centres_[index] = here.moved(link.com);

  const Vector3d c = from_reference(index, centres_[index]);
  SpatialInertia& inertia = inertias_[index];
  inertia.mass = link.mass;
  inertia.first_moment = link.mass * c;
  inertia.inertia.noalias() = here.turn * link.inertia * here.turn.transpose();
  inertia.inertia.diagonal().array() += link.mass * c.squaredNorm();
  inertia.inertia.noalias() -= link.mass * c * c.transpose();
}

Twist Dynamics::carrier(const Link& link, int i, std::span<const double> velocities) const {
  Twist carrier;
  if (link.parent >= 0) carrier = velocities_[static_cast<std::size_t>(link.parent)];
  if (link.kind == LinkKind::universal && i == 1)
    carrier += velocities[static_cast<std::size_t>(link.dof)] * axes_[static_cast<std::size_t>(link.dof)];
  // The axes of a floating body keep their directions and move with its centre of mass.
  if (link.kind == LinkKind::floating && i >= 3)
    for (int k = 0; k < 3; ++k) carrier.linear[k] = velocities[nth(link.dof, k)];
  return carrier;
}

void Dynamics::move(std::span<const double> velocities) {
  if (only_coordinate_) return;
  for (std::size_t index = 0; index < tree_.links().size(); ++index) {
    const Link& link = tree_.links()[index];
    Twist& velocity = velocities_[index];
    Twist& acceleration = accelerations_[index];
    velocity = {};
    acceleration = {};
    if (link.parent >= 0) {
      velocity = velocities_[static_cast<std::size_t>(link.parent)];
      acceleration = accelerations_[static_cast<std::size_t>(link.parent)];
    }
    for (int i = 0; i < link.dofs; ++i) {
      const auto dof = nth(link.dof, i);
      const Twist part = velocities[dof] * axes_[dof];
      acceleration += cross(carrier(link, i, velocities), part);
      velocity += part;
    }
  }
}

Vector3d Dynamics::centre_velocity(std::size_t link) const {
  const Twist& velocity = velocities_[link];
  return velocity.linear + velocity.angular.cross(from_reference(link, centres_[link]));
}

void Dynamics::inertia(std::span<double> out) {
  if (only_coordinate_) {
    out[0] = lone_inertia_;
    return;
  }
  const std::size_t n = tree_.dofs();
  std::fill(out.begin(), out.end(), 0.0);
  std::copy(inertias_.begin(), inertias_.end(), composites_.begin());
  for (std::size_t index = tree_.links().size(); index-- > 0;) {
    const Link& link = tree_.links()[index];
    for (int i = 0; i < link.dofs; ++i) {
      const auto dof = nth(link.dof, i);
      const Wrench momentum = composites_[index] * axes_[dof];
      const auto put = [&](int other) {
        const auto column = static_cast<std::size_t>(other);
        out[dof * n + column] = out[column * n + dof] = dot(axes_[column], momentum);
      };
      for (int k = 0; k <= i; ++k) put(link.dof + k);
      for (int holder = link.parent; holder >= 0; holder = tree_.links()[static_cast<std::size_t>(holder)].parent) {
        const Link& above = tree_.links()[static_cast<std::size_t>(holder)];
        for (int k = 0; k < above.dofs; ++k) put(above.dof + k);
      }
    }
    if (link.parent >= 0) composites_[static_cast<std::size_t>(link.parent)] += composites_[index];
  }
}

void Dynamics::bias(const Vector3d& gravity, std::span<const BodyForce> forces, std::span<double> out) {
  if (only_coordinate_) {
    out[0] = -lone_weight(gravity);
    return;
  }
  for (std::size_t index = 0; index < tree_.links().size(); ++index) {
    const Twist& velocity = velocities_[index];
    Twist acceleration = accelerations_[index];
    acceleration.linear -= gravity;
    Wrench& force = forces_[index];
    force = inertias_[index] * acceleration + cross(velocity, inertias_[index] * velocity);
    if (forces.empty()) continue;
    const BodyForce& outside = forces[index];
    force -= {outside.torque + from_reference(index, centres_[index]).cross(outside.force), outside.force};
  }
  for (std::size_t index = tree_.links().size(); index-- > 0;) {
    const Link& link = tree_.links()[index];
    for (int i = 0; i < link.dofs; ++i) {
      const auto dof = nth(link.dof, i);
      out[dof] = dot(axes_[dof], forces_[index]);
    }
    if (link.parent >= 0) forces_[static_cast<std::size_t>(link.parent)] += forces_[index];
  }
}

/// The generalised force of gravity on the only joint.
double Dynamics::lone_weight(const Vector3d& gravity) const {
  const Link& link = tree_.links().front();
  if (link.kind == LinkKind::slider) return link.mass * link.axes[0].dot(gravity);
  return std::cos(coordinate_) * at_quarter_.dot(gravity) - std::sin(coordinate_) * at_zero_.dot(gravity);
}

void Dynamics::add_drag(std::size_t link, double damping, double angular, std::span<double> inertia_like) const {
  const std::size_t n = tree_.dofs();
  const Vector3d c = from_reference(link, centres_[link]);
  const auto each_dof = [&](const auto& visit) {
    for (int index = static_cast<int>(link); index >= 0;
         index = tree_.links()[static_cast<std::size_t>(index)].parent) {
      const Link& one = tree_.links()[static_cast<std::size_t>(index)];
      for (int i = 0; i < one.dofs; ++i) visit(nth(one.dof, i));
    }
  };
  each_dof([&](std::size_t row) {
    const Vector3d along = axes_[row].linear + axes_[row].angular.cross(c);
    each_dof([&](std::size_t column) {
      const Vector3d other = axes_[column].linear + axes_[column].angular.cross(c);
      inertia_like[row * n + column] +=
          damping * along.dot(other) + angular * axes_[row].angular.dot(axes_[column].angular);
    });
  });
}

}  // namespace lacuna::articulated
