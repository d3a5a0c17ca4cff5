#include "simulation/articulated/dynamics.h"
#include "simulation/articulated/mujoco_robot.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lacuna {
namespace {

using articulated::Link;
using articulated::LinkKind;

constexpr double kAgreement = 1e-9;  ///< of the largest acceleration

struct State {
  std::vector<double> configuration, velocities;
};

State random_state(const articulated::Tree& tree, Draws& draws) {
  State state{std::vector<double>(tree.positions()), std::vector<double>(tree.dofs())};
  for (double& coordinate : state.configuration) coordinate = 2.0 * draws.number();
  for (double& velocity : state.velocities) velocity = 2.0 * draws.number();
  for (const Link& link : tree.links()) {
    double* q = &state.configuration[static_cast<std::size_t>(link.position)];
    if (link.kind != LinkKind::ball && link.kind != LinkKind::floating) continue;
    const Eigen::Quaterniond turn = draws.turn();
    if (link.kind == LinkKind::floating) q += 3;
    q[0] = turn.w();
    std::copy_n(turn.vec().data(), 3, q + 1);
  }
  return state;
}

Eigen::VectorXd own_accelerations(const articulated::Tree& tree, const State& state, const Eigen::Vector3d& gravity) {
  articulated::Dynamics dynamics(tree);
  const auto n = static_cast<Eigen::Index>(tree.dofs());
  Eigen::MatrixXd inertia(n, n);
  Eigen::VectorXd bias(n);
  dynamics.place(state.configuration, true);
  dynamics.move(state.velocities);
  dynamics.inertia({inertia.data(), tree.dofs() * tree.dofs()});
  dynamics.bias(gravity, {}, {bias.data(), tree.dofs()});
  return inertia.llt().solve(-bias);
}

TEST(AgainstMuJoCo, AccelerationsOfRandomTreesAreTheSame) {
  std::set<LinkKind> kinds;
  for (unsigned seed = 1; seed <= 66; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Draws draws(seed);
    const bool floating = seed % 3 == 0;
    RandomTree robot = random_tree(2 + static_cast<int>(seed % 11), floating, draws);
    // MuJoCo counts the motion of a floating body at its frame's origin, the tree at the centre of mass.
    if (floating) robot.robot.bodies[0].com.setZero();
    const articulated::Tree tree(robot.robot, simulation::make_joint_tree(robot.robot));
    for (const Link& link : tree.links()) kinds.insert(link.kind);
    const State state = random_state(tree, draws);
    const Eigen::VectorXd own = own_accelerations(tree, state, robot.robot.gravity);
    const std::vector<double> theirs =
        MujocoRobot(robot).accelerations(tree.links(), state.configuration, state.velocities);
    for (std::size_t i = 0; i < theirs.size(); ++i)
      EXPECT_NEAR(own(static_cast<Eigen::Index>(i)), theirs[i], kAgreement * own.cwiseAbs().maxCoeff()) << "dof " << i;
  }
  EXPECT_EQ(kinds,
            (std::set{LinkKind::hinge, LinkKind::slider, LinkKind::universal, LinkKind::ball, LinkKind::floating}));
}

}  // namespace
}  // namespace lacuna
