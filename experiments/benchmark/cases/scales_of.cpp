#include "cases/scales_of.h"

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

/// The size that a share of the values stays below.
double below_which(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  for (double& value : values) value = std::abs(value);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double positive(double value) { return value > 0.0 ? value : 1.0; }

void describe_motion(Scales& at, std::size_t joint, const std::vector<Motion>& motions) {
  std::vector<double> velocities;
  at.lowest = at.highest = motions.front().position[joint].front();
  for (const Motion& motion : motions) {
    for (const double q : motion.position[joint]) {
      at.lowest = std::min(at.lowest, q);
      at.highest = std::max(at.highest, q);
    }
    velocities.insert(velocities.end(), motion.velocity[joint].begin(), motion.velocity[joint].end());
  }
  at.position = positive(0.5 * (at.highest - at.lowest));
  at.velocity = positive(below_which(velocities, 0.95));
}

void describe_inertia(Scales& at, const PlantSpec& spec, std::size_t joint) {
  const auto n = static_cast<Eigen::Index>(spec.joints.size());
  Chain chain(spec);
  chain.move_to(Coordinates::Zero(n), Coordinates::Zero(n));
  CoordinateMatrix inertia = CoordinateMatrix::Zero(n, n);
  Coordinates force = Coordinates::Zero(n);
  chain.add_inertia(inertia, force);
  const PlantBody& body = spec.bodies[joint];
  at.inertia =
      inertia(static_cast<Eigen::Index>(joint), static_cast<Eigen::Index>(joint)) + spec.joints[joint].armature;
  at.mass = body.mass;
  at.lever = spec.joints[joint].slides ? 1.0 : positive(body.com.norm());
}

/// What moves the joint: inertia times acceleration and weight, whichever drive it comes from.
void describe_forces(Scales& at, std::size_t joint, const std::vector<Motion>& motions) {
  std::vector<double> forces;
  for (const Motion& motion : motions) {
    const std::vector<double>& v = motion.velocity[joint];
    const auto stride = static_cast<std::size_t>(motion.steps_a_sample);
    for (std::size_t k = stride; k < v.size(); k += stride)
      forces.push_back(at.inertia * (v[k] - v[k - stride]) / (static_cast<double>(stride) * motion.interval));
  }
  at.force = positive(rms(forces));
  at.peak_force = positive(below_which(forces, 0.999));
}

void describe_drive(Scales& at, const PlantDrive& drive, std::size_t number,
                    const std::vector<Excitation>& excitations) {
  std::vector<double> commands;
  for (const Excitation& excitation : excitations) {
    const std::vector<double>& held = excitation.commands[number];
    commands.insert(commands.end(), held.begin(), held.end());
  }
  at.command = positive(rms(commands));
  at.peak_command = positive(below_which(commands, 0.999));
  at.rotor = positive(drive.rotor_inertia);
  if (drive.servo) return;
  at.force = at.command;
  at.peak_force = at.peak_command;
}

}  // namespace

int joint_of(const PlantSpec& spec, Place place, int element) {
  const auto e = static_cast<std::size_t>(element);
  if (place == Place::drive) return spec.drives[e].joint;
  if (place == Place::sensor) return spec.sensors[e].joint;
  return place == Place::world ? 0 : element;
}

Scales scales_of(const PlantSpec& spec, Place place, int element, const std::vector<Excitation>& excitations,
                 const std::vector<Motion>& motions) {
  Scales at;
  const auto joint = static_cast<std::size_t>(joint_of(spec, place, element == kEverywhere ? 0 : element));
  describe_inertia(at, spec, joint);
  describe_motion(at, joint, motions);
  describe_forces(at, joint, motions);
  for (std::size_t d = 0; d < spec.drives.size(); ++d)
    if (spec.drives[d].joint == static_cast<int>(joint)) {
      at.inertia += spec.drives[d].rotor_inertia;
      describe_drive(at, spec.drives[d], d, excitations);
    }
  at.duration = static_cast<double>(excitations.front().samples() - 1) * excitations.front().interval;
  return at;
}

}  // namespace hidden_effects
