#include "cart_pole.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

namespace mujoco_cart_pole {
namespace {

/// The truth, in MuJoCo's language. `frictionloss` is what the model lacks: dry friction, N.
constexpr char kScene[] = R"(
<mujoco model="cart-pole">
  <option timestep="0.0005" integrator="RK4" gravity="0 0 -9.81"/>
  <worldbody>
    <body name="cart">
      <joint name="rail" type="slide" axis="1 0 0" frictionloss="0.8" solimpfriction="0.99 0.999 0.001"
             solreffriction="0.002 1"/>
      <inertial pos="0 0 0" mass="1.0" diaginertia="0.01 0.01 0.01"/>
      <body name="pole">
        <joint name="hinge" type="hinge" axis="0 1 0" damping="0.002"/>
        <inertial pos="0 0 -0.25" mass="0.2" diaginertia="0.0042 0.0042 0.0001"/>
      </body>
    </body>
  </worldbody>
  <actuator>
    <motor name="motor" joint="rail"/>
  </actuator>
</mujoco>
)";

mjModel* load_scene() {
  mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "scene.xml", sizeof(kScene) - 1);
  std::memcpy(files.filedata[0], kScene, sizeof(kScene) - 1);
  std::array<char, 1000> problem{};
  mjModel* model = mj_loadXML("scene.xml", &files, problem.data(), static_cast<int>(problem.size()));
  mj_deleteVFS(&files);
  if (model == nullptr) throw std::runtime_error("MuJoCo refuses the scene: " + std::string(problem.data()));
  return model;
}

}  // namespace

CartPole::CartPole() : model_(load_scene()), data_(mj_makeData(model_)) {}

CartPole::~CartPole() {
  mj_deleteData(data_);
  mj_deleteModel(model_);
}

void CartPole::reset(unsigned long long seed) {
  mj_resetData(model_, data_);
  noise_.seed(seed);
}

void CartPole::advance(double force, double seconds) {
  data_->ctrl[0] = force;
  const long steps = std::max(1L, std::lround(seconds / model_->opt.timestep));
  for (long i = 0; i < steps; ++i) mj_step(model_, data_);
}

Reading CartPole::read() {
  std::normal_distribution<double> normal;
  const double position = data_->qpos[0] + kPositionNoise * normal(noise_);
  return {position, data_->qpos[1] + kAngleNoise * normal(noise_)};
}

}  // namespace mujoco_cart_pole
