#include "plant/chain.h"

namespace hidden_effects {

void Chain::move_to(const Coordinates& q, const Coordinates& v) {
  InPlane origin = InPlane::Zero(), velocity = InPlane::Zero(), acceleration = InPlane::Zero();
  double angle = 0.0, rate = 0.0;
  for (std::size_t i = 0; i < spec_->joints.size(); ++i) {
    const PlantJoint& joint = spec_->joints[i];
    const auto k = static_cast<Eigen::Index>(i);
    Link& link = links_[i];
    link.axis = turned(joint.axis, angle);
    const InPlane reach = turned(joint.anchor, angle) + (joint.slides ? InPlane(q[k] * link.axis) : InPlane::Zero());
    origin += reach;
    velocity += rate * quarter_turned(reach);
    acceleration -= rate * rate * reach;
    if (joint.slides) {
      velocity += v[k] * link.axis;
      acceleration += 2.0 * rate * v[k] * quarter_turned(link.axis);
    } else {
      angle += q[k];
      rate += v[k];
    }
    const InPlane arm = turned(spec_->bodies[i].com, angle);
    link.origin = origin;
    link.com = origin + arm;
    link.velocity = velocity + rate * quarter_turned(arm);
    link.free_acceleration = acceleration - rate * rate * arm;
    link.angle = angle;
    link.rate = rate;
  }
}

InPlane Chain::column(int body, int joint) const {
  const Link& at = links_[static_cast<std::size_t>(joint)];
  if (spec_->joints[static_cast<std::size_t>(joint)].slides) return at.axis;
  return quarter_turned(links_[static_cast<std::size_t>(body)].com - at.origin);
}

void Chain::add_inertia(CoordinateMatrix& inertia, Coordinates& force) const {
  for (int b = 0; b < static_cast<int>(spec_->bodies.size()); ++b) {
    const PlantBody& body = spec_->bodies[static_cast<std::size_t>(b)];
    const InPlane load = body.mass * (spec_->gravity - links_[static_cast<std::size_t>(b)].free_acceleration);
    for (int i = 0; i <= b; ++i) {
      const InPlane of_i = column(b, i);
      const bool i_turns = !spec_->joints[static_cast<std::size_t>(i)].slides;
      force[i] += of_i.dot(load);
      for (int j = 0; j <= i; ++j) {
        const bool both_turn = i_turns && !spec_->joints[static_cast<std::size_t>(j)].slides;
        const double entry = body.mass * of_i.dot(column(b, j)) + (both_turn ? body.inertia : 0.0);
        inertia(i, j) += entry;
        if (i != j) inertia(j, i) += entry;
      }
    }
  }
}

void Chain::add_body_force(int body, const InPlane& force, Coordinates& at_joints) const {
  for (int i = 0; i <= body; ++i) at_joints[i] += column(body, i).dot(force);
}

}  // namespace hidden_effects
