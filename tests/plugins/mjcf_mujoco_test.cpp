#include "plugins/built_catalog.h"
#include "simulation/articulated/dynamics.h"
#include "support/test_folder.h"

#include <lacuna/robot_format.h>

#include <Eigen/Cholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <memory>
#include <random>
#include <string>

/// What the plugin reads of an MJCF file moves as MuJoCo says that it does.
namespace lacuna {
namespace {

using articulated::Link;
using articulated::LinkKind;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kAgreement = 1e-9;  ///< of the largest acceleration

std::unique_ptr<mjModel, decltype(&mj_deleteModel)> compiled_by_mujoco(const std::string& scene) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(scene.size()));
  std::memcpy(files->filedata[0], scene.data(), scene.size());
  std::array<char, 1000> problem{};
  mjModel* model = mj_loadXML("scene.xml", files.get(), problem.data(), static_cast<int>(problem.size()));
  mj_deleteVFS(files.get());
  EXPECT_NE(model, nullptr) << problem.data();
  if (model) model->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT;  // it touches nothing here, and has no stops
  return {model, &mj_deleteModel};
}

class Randoms {
 public:
  double number() { return 2.0 * (static_cast<double>(generator_()) / 4294967296.0) - 1.0; }
  Vector3d vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Quaterniond turn() {
    const Vector3d axis = vector();
    return Quaterniond(Eigen::AngleAxisd(2.0 * number(), axis.normalized()));
  }

 private:
  std::mt19937 generator_{7};
};

/// One text, read by both.
class ReadTwice {
 public:
  explicit ReadTwice(const std::string& text)
      : read_(built_catalog().get<RobotFormat>("mjcf").read({"scene.xml", text})),
        model_(compiled_by_mujoco(text)),
        data_(mj_makeData(model_.get()), &mj_deleteData),
        tree_(read_.robot, simulation::make_joint_tree(read_.robot)) {
    EXPECT_THAT(read_.problems, testing::IsEmpty());
  }

  /// At a state and commands that are drawn.
  void expect_same_accelerations(Randoms& draws) {
    std::vector<double> q(tree_.positions()), v(tree_.dofs());
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(tree_.dofs()));
    Eigen::VectorXd armature = forces;
    for (const Link& link : tree_.links()) put(link, draws, q, v, forces, armature);
    for (std::size_t a = 0; a < read_.robot.actuators.size(); ++a) drive(a, draws, q, v, forces);
    mj_forward(model_.get(), data_.get());
    const Eigen::VectorXd own = accelerations(q, v, forces, armature);
    const Eigen::VectorXd theirs = theirs_of(q, v);
    EXPECT_LT((own - theirs).cwiseAbs().maxCoeff(), kAgreement * own.cwiseAbs().maxCoeff()) << own.transpose() << "\n"
                                                                                            << theirs.transpose();
  }

  const RobotSpec& robot() const { return read_.robot; }

 private:
  const JointSpec& joint_of(const Link& link) const {
    const std::string& body = read_.robot.bodies[static_cast<std::size_t>(link.body)].name;
    return *std::find_if(read_.robot.joints.begin(), read_.robot.joints.end(),
                         [&](const JointSpec& one) { return one.child == body; });
  }
  int mujoco_joint(const std::string& name) const { return mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str()); }
  double reference(const std::string& joint) const {
    for (const SensorSpec& sensor : read_.robot.sensors)
      if (sensor.kind == SensorKind::joint_position && sensor.element == joint) return sensor.offset;
    return 0.0;
  }
  const BodySpec& body_of(const Link& link) const { return read_.robot.bodies[static_cast<std::size_t>(link.body)]; }

  void put(const Link& link, Randoms& draws, std::vector<double>& q, std::vector<double>& v, Eigen::VectorXd& forces,
           Eigen::VectorXd& armature) {
    const JointSpec& joint = joint_of(link);
    if (link.kind == LinkKind::floating) return float_away(link, draws, q, v);
    const auto at = static_cast<std::size_t>(link.position);
    const auto dof = static_cast<Eigen::Index>(link.dof);
    q[at] = 0.4 * draws.number();
    v[static_cast<std::size_t>(dof)] = 2.0 * draws.number();
    forces(dof) = -joint.damping * v[static_cast<std::size_t>(dof)] - joint.stiffness * (q[at] - joint.rest);
    armature(dof) = joint.armature;
    const int theirs = mujoco_joint(joint.name);
    ASSERT_GE(theirs, 0) << joint.name;
    data_->qpos[model_->jnt_qposadr[theirs]] = q[at] + reference(joint.name);
    data_->qvel[model_->jnt_dofadr[theirs]] = v[static_cast<std::size_t>(dof)];
  }

  void float_away(const Link& link, Randoms& draws, std::vector<double>& q, std::vector<double>& v) {
    const BodySpec& body = body_of(link);
    const Vector3d centre = draws.vector(), velocity = draws.vector(), spin = draws.vector();
    const Quaterniond turn = draws.turn(), axes = turn * body.orientation;
    const Vector3d arm = axes * body.com, origin = centre - arm, origin_velocity = velocity - spin.cross(arm);
    const double ours[] = {centre.x(), centre.y(), centre.z(), turn.w(), turn.x(), turn.y(), turn.z()};
    std::copy(std::begin(ours), std::end(ours), q.begin() + link.position);
    std::copy_n(velocity.data(), 3, v.begin() + link.dof);
    std::copy_n(spin.data(), 3, v.begin() + link.dof + 3);
    const Vector3d spin_in_body = axes.conjugate() * spin;
    const double theirs[] = {origin.x(), origin.y(), origin.z(), axes.w(), axes.x(), axes.y(), axes.z()};
    std::copy(std::begin(theirs), std::end(theirs), data_->qpos);
    std::copy_n(origin_velocity.data(), 3, data_->qvel);
    std::copy_n(spin_in_body.data(), 3, data_->qvel + 3);
  }

  void drive(std::size_t index, Randoms& draws, const std::vector<double>& q, const std::vector<double>& v,
             Eigen::VectorXd& forces) {
    const ActuatorSpec& actuator = read_.robot.actuators[index];
    const double command = draws.number();
    const int theirs = mj_name2id(model_.get(), mjOBJ_ACTUATOR, actuator.name.c_str());
    if (theirs < 0) return;  // guessed, where the file has none
    data_->ctrl[theirs] = command;
    for (const Link& link : tree_.links()) {
      if (link.kind == LinkKind::floating || joint_of(link).name != actuator.joint) continue;
      const double position = q[static_cast<std::size_t>(link.position)],
                   velocity = v[static_cast<std::size_t>(link.dof)];
      const double target =
          std::clamp(actuator.gain * command + actuator.offset, actuator.command_lower, actuator.command_upper);
      double force = target;
      if (actuator.kind == ActuatorKind::position_servo)
        force = actuator.kp * (target - position) - actuator.kd * velocity;
      if (actuator.kind == ActuatorKind::velocity_servo) force = actuator.kd * (target - velocity);
      forces(link.dof) += std::clamp(force, -actuator.force_limit, actuator.force_limit);
    }
  }

  Eigen::VectorXd accelerations(const std::vector<double>& q, const std::vector<double>& v,
                                const Eigen::VectorXd& forces, const Eigen::VectorXd& armature) {
    articulated::Dynamics dynamics(tree_);
    const auto n = static_cast<Eigen::Index>(tree_.dofs());
    Eigen::MatrixXd inertia(n, n);
    Eigen::VectorXd bias(n);
    dynamics.place(q, true);
    dynamics.move(v);
    dynamics.inertia({inertia.data(), tree_.dofs() * tree_.dofs()});
    dynamics.bias(read_.robot.gravity, {}, {bias.data(), tree_.dofs()});
    inertia.diagonal() += armature;
    return inertia.llt().solve(forces - bias);
  }

  /// As our tree counts them: of a floating body at its centre of mass, along the world's axes.
  Eigen::VectorXd theirs_of(const std::vector<double>& q, const std::vector<double>& v) const {
    Eigen::VectorXd found(static_cast<Eigen::Index>(tree_.dofs()));
    for (const Link& link : tree_.links()) {
      if (link.kind != LinkKind::floating) {
        found(link.dof) = data_->qacc[model_->jnt_dofadr[mujoco_joint(joint_of(link).name)]];
        continue;
      }
      const double* turn = &q[static_cast<std::size_t>(link.position) + 3];
      const Quaterniond axes = Quaterniond(turn[0], turn[1], turn[2], turn[3]) * body_of(link).orientation;
      const Vector3d spin = Eigen::Map<const Vector3d>(&v[static_cast<std::size_t>(link.dof) + 3]);
      const Vector3d arm = axes * body_of(link).com;
      const Vector3d angular = axes * Vector3d(Eigen::Map<const Vector3d>(data_->qacc + 3));
      found.segment<3>(link.dof) =
          Vector3d(Eigen::Map<const Vector3d>(data_->qacc)) + angular.cross(arm) + spin.cross(spin.cross(arm));
      found.segment<3>(link.dof + 3) = angular;
    }
    return found;
  }

  ReadRobot read_;
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_;
  articulated::Tree tree_;
};

void expect_same_motion(const std::string& text) {
  Randoms draws;
  ReadTwice both(text);
  for (int state = 0; state < 5; ++state) both.expect_same_accelerations(draws);
}

TEST(MjcfAgainstMuJoCo, APendulumWithAllThatAJointHas) {
  expect_same_motion(R"(<mujoco>
  <worldbody><body name="arm" pos="0 0 1">
    <joint name="hinge" axis="0 1 0" pos="0 0 0.1" damping="0.3" stiffness="2" springref="20" armature="0.01"/>
    <inertial pos="0 0.02 -0.3" mass="1.5" diaginertia="0.02 0.03 0.015" euler="10 20 30"/>
  </body></worldbody>
  <actuator><motor name="m" joint="hinge" gear="3"/></actuator>
</mujoco>)");
}

TEST(MjcfAgainstMuJoCo, AnArmWithTurnedFramesAndClassesOfDefaults) {
  expect_same_motion(R"(<mujoco model="arm">
  <compiler angle="radian" eulerseq="zyx"/>
  <option gravity="0.1 -0.2 -9.7"/>
  <default>
    <joint damping="0.1"/>
    <default class="heavy"><joint armature="0.2" axis="1 0 1"/><geom density="4000"/>
      <default class="wrist"><joint axis="1 2 0" damping="0.7"/></default>
    </default>
  </default>
  <worldbody>
    <body name="upper" pos="0.1 0.2 0.9" euler="0.3 -0.4 0.5" childclass="heavy">
      <joint name="shoulder"/>
      <geom type="capsule" fromto="0 0 0 0.1 0.2 0.4" size="0.04"/>
      <geom type="box" pos="0 0.1 0" size="0.05 0.06 0.07" axisangle="1 1 0 0.6"/>
      <body name="plate" pos="0 0 0.4" xyaxes="0 1 0 -1 0 0.3"><geom type="cylinder" size="0.06 0.02" mass="0.8"/>
        <body name="lower" pos="0.1 0 0.1" zaxis="1 2 3">
          <joint name="elbow" class="wrist" pos="0.01 0.02 0.03"/>
          <joint name="twist" axis="0 0 1"/>
          <joint name="reach" type="slide" axis="0 1 1" class="main" stiffness="5" springref="0.05"/>
          <geom type="ellipsoid" size="0.03 0.05 0.2" quat="0.9 0.1 0.2 0.3" pos="0 0 0.1" density="700"/>
          <geom type="sphere" size="0.05" pos="0 0 0.3"/>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator>
    <position name="p" joint="shoulder" kp="20" gear="2" ctrlrange="-0.3 0.4" ctrllimited="true"/>
    <velocity name="v" joint="elbow" kv="1.5" gear="-1"/>
    <general name="g" joint="reach" gainprm="30" biastype="affine" biasprm="2 -40 -3" forcerange="-4 4" forcelimited="true"/>
    <general name="t" joint="twist" gainprm="2" biastype="affine" biasprm="0.5 0 0"/>
  </actuator>
</mujoco>)");
}

TEST(MjcfAgainstMuJoCo, ASlideWhosePositionsAreCountedFromAReference) {
  expect_same_motion(R"(<mujoco>
  <worldbody><body name="cart" pos="0 0 1" quat="1 0.2 0 0">
    <joint name="rail" type="slide" axis="0 0 1" ref="0.5" springref="0.6" stiffness="100" damping="2"/>
    <geom type="box" size="0.1 0.1 0.1" density="500"/>
    <body name="pole" pos="0 0.1 0">
      <joint name="swing" axis="1 0 0" ref="30"/>
      <geom type="capsule" size="0.02 0.3" pos="0 0 0.3"/>
    </body>
  </body></worldbody>
  <actuator><position name="p" joint="rail" kp="50"/><position name="s" joint="swing" kp="3"/></actuator>
</mujoco>)");
}

TEST(MjcfAgainstMuJoCo, ABodyThatFloatsWithALeg) {
  expect_same_motion(R"(<mujoco>
  <worldbody><body name="trunk" pos="0.3 0.2 1" euler="10 20 30">
    <freejoint name="root"/>
    <inertial pos="0.05 0.01 -0.02" mass="8" fullinertia="0.3 0.4 0.5 0.01 0.02 -0.03"/>
    <body name="thigh" pos="0.2 0.1 0"><joint name="hip" axis="1 0 0" armature="0.01"/>
      <geom type="capsule" fromto="0 0 0 0 0 -0.3" size="0.03"/>
      <body name="shank" pos="0 0 -0.3"><joint name="knee" axis="0 1 0"/>
        <geom type="capsule" fromto="0 0 0 0 0 -0.3" size="0.02"/></body>
    </body>
  </body></worldbody>
  <actuator><motor name="h" joint="hip"/></actuator>
</mujoco>)");
}

TEST(MjcfAgainstMuJoCo, WhatTheCompilerBoundsAndBalances) {
  expect_same_motion(R"(<mujoco>
  <compiler boundmass="0.5" boundinertia="0.002" balanceinertia="true" inertiafromgeom="auto"/>
  <worldbody><body name="a"><joint name="j" axis="0 1 0"/>
    <inertial pos="0.1 0 0" mass="0.3" diaginertia="0.001 0.001 0.05"/>
    <body name="b" pos="0.3 0 0"><joint name="k" axis="0 1 0"/><geom size="0.01" pos="0.1 0 0"/></body>
  </body></worldbody>
</mujoco>)");
}

/// Files as their authors wrote them (tests/robots/README.md).
TEST(MjcfAgainstMuJoCo, RobotsOfOthers) {
  for (const char* name : {"mujoco/humanoid.xml", "gym/ant.xml", "gym/half_cheetah.xml"}) {
    SCOPED_TRACE(name);
    expect_same_motion(read_bytes(std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests/robots" / name));
  }
}

}  // namespace
}  // namespace lacuna
