#include "simulation/articulated/mujoco_robot.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

namespace lacuna {
namespace {

using articulated::Link;
using articulated::LinkKind;
using Eigen::Quaterniond;
using Eigen::Vector3d;

std::string text(const Vector3d& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z()); }
std::string text(const Quaterniond& q) { return fmt::format("{:.17g} {}", q.w(), text(Vector3d(q.vec()))); }

/// Along the principal axes, for MuJoCo finds these to seven digits only.
std::string inertial(const BodySpec& body) {
  const InertiaSpec& I = body.inertia;
  Eigen::Matrix3d inertia;
  inertia << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
  Eigen::Matrix3d frame = principal.eigenvectors();
  if (frame.determinant() < 0.0) frame.col(0) *= -1.0;
  return fmt::format(R"(<inertial pos="{}" mass="{:.17g}" quat="{}" diaginertia="{}"/>)", text(body.com), body.mass,
                     text(Quaterniond(frame)), text(Vector3d(principal.eigenvalues())));
}

std::string joints(const RobotSpec& robot, const BodySpec& body) {
  const auto joint = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const JointSpec& one) { return one.child == body.name; });
  if (joint == robot.joints.end()) return "<freejoint/>";
  const Quaterniond to_body = body.orientation.conjugate();
  const auto write = [&](const char* type, const Vector3d& axis) {
    return fmt::format(R"(<joint type="{}" pos="{}" axis="{}"/>)", type,
                       text(Vector3d(to_body * (joint->anchor - body.position))), text(Vector3d(to_body * axis)));
  };
  switch (joint->kind) {
    case JointKind::hinge: return write("hinge", joint->axis);
    case JointKind::slider: return write("slide", joint->axis);
    case JointKind::universal: return write("hinge", joint->axis) + write("hinge", joint->axis2);
    case JointKind::ball: return write("ball", joint->axis);
    case JointKind::free: return "<freejoint/>";
    case JointKind::fixed: break;
  }
  return {};
}

std::string bodies_on(int parent, const RobotSpec& robot, const std::vector<int>& parents) {
  Vector3d place(0.0, 0.0, 0.0);
  Quaterniond turn = Quaterniond::Identity();
  if (parent >= 0) {
    place = robot.bodies[static_cast<std::size_t>(parent)].position;
    turn = robot.bodies[static_cast<std::size_t>(parent)].orientation;
  }
  std::string all;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (parents[i] != parent) continue;
    const BodySpec& body = robot.bodies[i];
    all += fmt::format(R"(<body name="{}" pos="{}" quat="{}">)", body.name,
                       text(Vector3d(turn.conjugate() * (body.position - place))),
                       text(turn.conjugate() * body.orientation));
    all += inertial(body) + joints(robot, body) + bodies_on(static_cast<int>(i), robot, parents) + "</body>";
  }
  return all;
}

mjModel* load(const RandomTree& tree) {
  const std::string scene = fmt::format(
      R"(<mujoco><compiler angle="radian" inertiafromgeom="false"/><option gravity="{}"/><worldbody>{}</worldbody></mujoco>)",
      text(tree.robot.gravity), bodies_on(-1, tree.robot, tree.parents));
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(scene.size()));
  std::memcpy(files->filedata[0], scene.data(), scene.size());
  std::array<char, 1000> problem{};
  mjModel* model = mj_loadXML("scene.xml", files.get(), problem.data(), static_cast<int>(problem.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error("MuJoCo refuses the scene: " + std::string(problem.data()));
  return model;
}

Quaterniond turn_of(const Link& link, const double* q) {
  const double* turn = link.kind == LinkKind::floating ? q + 3 : q;
  return {turn[0], turn[1], turn[2], turn[3]};
}

void put_turn(const Quaterniond& turn, double* out) {
  const Quaterniond unit = turn.normalized();
  out[0] = unit.w();
  std::copy_n(unit.vec().data(), 3, out + 1);
}

void copy_turned(const Quaterniond& turn, const double* from, double* to) {
  const Vector3d turned = turn * Vector3d(from[0], from[1], from[2]);
  std::copy_n(turned.data(), 3, to);
}

}  // namespace

MujocoRobot::MujocoRobot(const RandomTree& tree)
    : robot_(tree.robot),
      parents_(tree.parents),
      model_(load(tree), &mj_deleteModel),
      data_(mj_makeData(model_.get()), &mj_deleteData) {}

/// Of the body, against the axes that its turn is counted in.
Quaterniond MujocoRobot::at_zero(const Link& link) const {
  const auto body = static_cast<std::size_t>(link.body);
  const int parent = parents_[body];
  const Quaterniond own = robot_.bodies[body].orientation;
  return parent < 0 ? own : robot_.bodies[static_cast<std::size_t>(parent)].orientation.conjugate() * own;
}

Quaterniond MujocoRobot::axes(const Link& link, const double* q) const {
  return (turn_of(link, q) * at_zero(link)).conjugate();
}

int MujocoRobot::joint_of(const Link& link) const {
  const std::string& name = robot_.bodies[static_cast<std::size_t>(link.body)].name;
  return model_->body_jntadr[mj_name2id(model_.get(), mjOBJ_BODY, name.c_str())];
}

void MujocoRobot::put(const Link& link, const double* q, const double* v) {
  const int joint = joint_of(link);
  double* position = data_->qpos + model_->jnt_qposadr[joint];
  double* velocity = data_->qvel + model_->jnt_dofadr[joint];
  if (link.kind == LinkKind::ball) {
    put_turn(at_zero(link).conjugate() * turn_of(link, q) * at_zero(link), position);
    copy_turned(axes(link, q), v, velocity);
  } else if (link.kind == LinkKind::floating) {
    std::copy_n(q, 3, position);
    put_turn(turn_of(link, q) * at_zero(link), position + 3);
    std::copy_n(v, 3, velocity);
    copy_turned(axes(link, q), v + 3, velocity + 3);
  } else {
    std::copy_n(q, link.dofs, position);
    std::copy_n(v, link.dofs, velocity);
  }
}

void MujocoRobot::read_accelerations(const Link& link, const double* q, double* out) const {
  const double* found = data_->qacc + model_->jnt_dofadr[joint_of(link)];
  std::copy_n(found, link.dofs, out);
  if (link.kind == LinkKind::ball) copy_turned(axes(link, q).conjugate(), found, out);
  if (link.kind == LinkKind::floating) copy_turned(axes(link, q).conjugate(), found + 3, out + 3);
}

std::vector<double> MujocoRobot::accelerations(const std::vector<Link>& links, std::span<const double> configuration,
                                               std::span<const double> velocities) {
  for (const Link& link : links)
    put(link, &configuration[static_cast<std::size_t>(link.position)], &velocities[static_cast<std::size_t>(link.dof)]);
  mj_forward(model_.get(), data_.get());
  std::vector<double> found(velocities.size());
  for (const Link& link : links)
    read_accelerations(link, &configuration[static_cast<std::size_t>(link.position)],
                       &found[static_cast<std::size_t>(link.dof)]);
  return found;
}

}  // namespace lacuna
