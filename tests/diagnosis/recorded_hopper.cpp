#include "diagnosis/recorded_hopper.h"

#include "fitting/seeded_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kTrunk = 4.0, kFoot = 0.6;          // kg
constexpr double kSpring = 2500.0, kDamping = 15.0;  // N/m, N·s/m, of the leg
constexpr double kGravity = 9.81;                    // m/s²
constexpr double kInterval = 0.005;                  // s, of the recording
constexpr int kSteps = 250;                          // an interval
constexpr double kH = kInterval / kSteps;            // s
constexpr double kStops = 1e-2;                      // m/s, slower impacts do not bounce

/// Heights over the position in which the foot just touches, and their speeds.
struct Hopper {
  double trunk = kHopperDrop, foot = kHopperDrop, trunk_speed = 0.0, foot_speed = 0.0;
  bool touches = false;

  void step(const HopperTruth& truth, double motor) {
    const double stretch = trunk - foot, speed = trunk_speed - foot_speed;
    const double dry = truth.dry * std::tanh(speed / 1e-4);
    const double leg = motor - kSpring * stretch - (kDamping + truth.viscous) * speed - dry;
    trunk_speed += kH * (leg / kTrunk - kGravity);
    foot_speed += kH * (-leg / kFoot - kGravity);
    touches = foot <= 0.0;
    if (touches && foot_speed < 0.0) foot_speed = foot_speed < -kStops ? -truth.restitution * foot_speed : 0.0;
    trunk += kH * trunk_speed;
    foot = std::max(0.0, foot + kH * foot_speed);
  }
};

/// Pushes of random strength, each held for a tenth of a second or two.
std::vector<double> motor_program(std::size_t samples, SeededNoise& random) {
  std::vector<double> force;
  while (force.size() < samples) {
    const auto held = static_cast<std::size_t>(random.uniform(0.1, 0.25) / kInterval);
    force.insert(force.end(), held, random.uniform(-60.0, 140.0));
  }
  force.resize(samples);
  return force;
}

Trial hop(const HopperTruth& truth, std::size_t number, double duration) {
  const auto samples = static_cast<std::size_t>(std::lround(duration / kInterval)) + 1;
  const auto rows = static_cast<Eigen::Index>(samples);
  SeededNoise commanded(99, number), random(truth.seed, number);
  const std::vector<double> force = motor_program(samples, commanded);
  Trial trial;
  trial.name = std::to_string(number) + ".csv";
  trial.measured.channels = {{"length", "m"}, {"ground", "1"}};
  trial.measured.times = Eigen::VectorXd::LinSpaced(rows, 0.0, duration);
  trial.measured.samples.resize(rows, 2);
  trial.commands.series = {{{"motor", "N"}}, trial.measured.times, TimeSeries::Samples(rows, 1)};
  trial.initial = {{InitialKnowledge::given, kHopperDrop, 0.0}, {InitialKnowledge::given, 0.0, 0.0}};
  Hopper hopper;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    trial.measured.samples.row(row) << hopper.trunk - hopper.foot + truth.noise * random.normal(),
        (hopper.touches ? 1.0 : -1.0);
    trial.commands.series.samples(row, 0) = force[i];
    for (int k = 0; k < kSteps; ++k) hopper.step(truth, force[i]);
  }
  return trial;
}

}  // namespace

std::vector<Trial> hopper_trials(const HopperTruth& truth, std::size_t count, double duration) {
  std::vector<Trial> trials;
  for (std::size_t number = 0; number < count; ++number) trials.push_back(hop(truth, number, duration));
  return trials;
}

std::string hopper_robot_file() {
  return fmt::format(R"([robot]
name = "hopper"
[body.trunk]
mass = {}
at = [0.0, 0.0, 0.5]
inertia = [0.01, 0.01, 0.01]
[body.foot]
mass = {}
at = [0.0, 0.0, 0.03]
inertia = [0.001, 0.001, 0.001]
shapes = [{{ kind = "sphere", radius = 0.03 }}]
[contact]
ground = true
[joint.rail]
kind = "slider"
child = "trunk"
axis = "z"
[joint.leg]
kind = "slider"
parent = "trunk"
child = "foot"
axis = [0.0, 0.0, -1.0]
stiffness = {}
damping = {}
[actuator.motor]
joint = "leg"
kind = "force"
[sensor.length]
kind = "joint_position"
joint = "leg"
noise = "0.2 mm"
[sensor.ground]
kind = "touch"
body = "foot"
)",
                     kTrunk, kFoot, kSpring, kDamping);
}

std::string hopper_model() {
  return R"([model]
file = "hopper.toml"
free = { "body.trunk.mass" = [2.0, 8.0] }
[engine]
step = "1 ms"
substeps = 2
)";
}

std::string hopper_experiment(std::size_t trials) {
  std::string files;
  for (std::size_t i = 0; i < trials; ++i) files += fmt::format("{}\"{}.csv\"", i > 0 ? ", " : "", i);
  return fmt::format(R"([experiment]
name = "hopper"
[target]
kind = "recorded"
files = [{}]
time = {{ column = "t_s" }}
sensors = {{ length = {{ column = "length", unit = "m" }}, ground = {{ column = "ground", unit = "1" }} }}
commands = {{ motor = {{ column = "motor", unit = "N" }} }}
[target.initial]
rail = {{ position = {}, knowledge = "given" }}
leg = {{ position = 0.0, knowledge = "given" }}
)",
                     files, kHopperDrop) +
         hopper_model();
}

}  // namespace lacuna
