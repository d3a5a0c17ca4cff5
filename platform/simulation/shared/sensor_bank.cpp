#include "simulation/shared/sensor_bank.h"

#include "foundation/address.h"
#include "foundation/text/number_text.h"
#include "simulation/shared/joint_tree.h"

#include <lacuna/error.h>

#include <algorithm>

namespace lacuna::simulation {
namespace {

bool reads_motion_of_body(SensorKind kind) {
  return !reads_joint(kind) && kind != SensorKind::touch && kind != SensorKind::contact_force;
}

/// From the body frame's origin to the centre of mass, in the world.
Eigen::Vector3d arm(const RobotSpec& robot, std::size_t body, const StepView& view) {
  return view.body_orientations[body] * robot.bodies[body].com;
}

void put(const Eigen::Vector3d& vector, std::span<double> out) { std::copy_n(vector.data(), 3, out.begin()); }

}  // namespace

SensorBank::SensorBank(const RobotSpec& robot, std::span<const Delay> longest) : delays_(robot.sensors.size()) {
  for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
    const SensorSpec& sensor = robot.sensors[i];
    const int element =
        reads_joint(sensor.kind) ? index_of(robot.joints, sensor.element) : index_of(robot.bodies, sensor.element);
    elements_.push_back(static_cast<std::size_t>(element));
    const bool of_link = sensor.kind == SensorKind::link_angle || sensor.kind == SensorKind::link_velocity;
    turns_.push_back(of_link ? turns_of_link(robot, sensor.element) : std::vector<LinkTurn>{});
    first_channel_.push_back(readings_.size());
    const std::size_t channels = sensor_channels(robot, sensor).size();
    readings_.resize(readings_.size() + channels);
    for (std::size_t channel = 0; channel < channels; ++channel) lines_.emplace_back(longest[i]);
    if (sensor.kind == SensorKind::accelerometer) last_.resize(robot.sensors.size());
    has_memory_ = has_memory_ || !longest[i].none() || sensor.kind == SensorKind::accelerometer;
    reads_bodies_ = reads_bodies_ || reads_motion_of_body(sensor.kind);
  }
  first_channel_.push_back(readings_.size());
}

void SensorBank::configure(const RobotSpec& robot, const EngineSettings& settings) {
  robot_ = &robot;
  for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
    const SensorSpec& sensor = robot.sensors[i];
    if (!(sensor.delay >= 0.0 && sensor.delay < kInfinity))
      throw Error("sensor \"" + sensor.name + "\": its delay is " + number_text(sensor.delay) + " s");
    delays_[i] = make_delay(sensor.delay, settings);
    if (!lines_[first_channel_[i]].reaches(delays_[i]))
      throw Error("sensor \"" + sensor.name + "\": its delay of " + number_text(sensor.delay) +
                  " s is longer than its parameters' upper bounds allow");
  }
}

void SensorBank::start(const StepView& view, const SensedForces& forces, EffectRunner& effects) {
  remember(view);
  read(view, forces);
  for (std::size_t channel = 0; channel < lines_.size(); ++channel) lines_[channel].fill(readings_[channel]);
  refine(view, effects);
}

void SensorBank::advance(const StepView& view, const SensedForces& forces, EffectRunner& effects) {
  read(view, forces);
  remember(view);
  for (std::size_t i = 0; i < delays_.size(); ++i) {
    for (std::size_t channel = first_channel_[i]; channel < first_channel_[i + 1]; ++channel) {
      lines_[channel].push(readings_[channel]);
      if (!delays_[i].none()) readings_[channel] = lines_[channel].read(delays_[i]);
    }
  }
  refine(view, effects);
}

void SensorBank::read(const StepView& view, const SensedForces& forces) {
  for (std::size_t i = 0; i < elements_.size(); ++i)
    read_one(i, view, forces,
             std::span(readings_).subspan(first_channel_[i], first_channel_[i + 1] - first_channel_[i]));
}

void SensorBank::remember(const StepView& view) {
  for (std::size_t i = 0; i < last_.size(); ++i)
    if (robot_->sensors[i].kind == SensorKind::accelerometer) last_[i] = {velocity_of_point(i, view), view.time};
}

Eigen::Vector3d SensorBank::velocity_of_point(std::size_t index, const StepView& view) const {
  const std::size_t body = elements_[index];
  const Eigen::Vector3d from_centre =
      view.body_orientations[body] * (robot_->sensors[index].at - robot_->bodies[body].com);
  return view.body_velocities[body] + view.body_angular_velocities[body].cross(from_centre);
}

/// At the start, where no time has passed, that of rest.
Eigen::Vector3d SensorBank::specific_force(std::size_t index, const StepView& view) const {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  if (const double passed = view.time - last_[index].time; passed > 0.0)
    acceleration = (velocity_of_point(index, view) - last_[index].velocity) / passed;
  return view.body_orientations[elements_[index]].conjugate() * (acceleration - robot_->gravity);
}

void SensorBank::read_one(std::size_t index, const StepView& view, const SensedForces& forces,
                          std::span<double> out) const {
  const SensorSpec& sensor = robot_->sensors[index];
  const std::size_t element = elements_[index];
  const auto sum_over_turns = [&](std::span<const double> values) {
    out[0] = 0.0;
    for (const LinkTurn& turn : turns_[index])
      out[0] +=
          turn.sign * values[static_cast<std::size_t>(view.first_coordinate[static_cast<std::size_t>(turn.joint)])];
  };
  const auto copy_coordinates = [&](std::span<const double> values) {
    const auto first = static_cast<std::size_t>(view.first_coordinate[element]);
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
  switch (sensor.kind) {
    case SensorKind::joint_position: copy_coordinates(view.positions); break;
    case SensorKind::joint_velocity: copy_coordinates(view.velocities); break;
    case SensorKind::joint_force: copy_coordinates(forces.joint_forces); break;
    case SensorKind::link_angle: sum_over_turns(view.positions); break;
    case SensorKind::link_velocity: sum_over_turns(view.velocities); break;
    case SensorKind::drive_force:
      std::fill(out.begin(), out.end(), 0.0);
      for (std::size_t a = 0; a < view.actuator_forces.size(); ++a)
        if (view.actuator_coordinate[a] == view.first_coordinate[element]) out[0] += view.actuator_forces[a];
      break;
    case SensorKind::touch: out[0] = forces.touching[element] ? 1.0 : -1.0; break;
    case SensorKind::body_position: put(view.body_positions[element] - arm(*robot_, element, view), out); break;
    case SensorKind::body_velocity:
      put(view.body_velocities[element] - view.body_angular_velocities[element].cross(arm(*robot_, element, view)),
          out);
      break;
    case SensorKind::body_orientation: {
      const Eigen::Quaterniond& q = view.body_orientations[element];
      const double sign = q.w() < 0.0 ? -1.0 : 1.0;
      const double values[] = {sign * q.w(), sign * q.x(), sign * q.y(), sign * q.z()};
      std::copy_n(values, 4, out.begin());
      break;
    }
    case SensorKind::body_angular_velocity: put(view.body_angular_velocities[element], out); break;
    case SensorKind::beacon_range:
      out[0] = (view.body_positions[element] - arm(*robot_, element, view) - sensor.beacon).norm();
      break;
    case SensorKind::contact_force: put(forces.contact_forces[element], out); break;
    case SensorKind::accelerometer: put(specific_force(index, view), out); break;
  }
}

void SensorBank::refine(const StepView& view, EffectRunner& effects) {
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const SensorSpec& sensor = robot_->sensors[i];
    const auto channels = std::span(readings_).subspan(first_channel_[i], first_channel_[i + 1] - first_channel_[i]);
    effects.sense(i, channels, view);
    if (sensor.scale == 1.0 && sensor.offset == 0.0) continue;
    for (double& value : channels) value = sensor.scale * value + sensor.offset;
  }
}

void SensorBank::save(StateWriter& writer) const {
  writer.put(readings_);
  for (const DelayLine& line : lines_) line.save(writer);
  for (const LastMotion& last : last_) {
    writer.put(std::span(last.velocity.data(), 3));
    writer.put(last.time);
  }
}

void SensorBank::load(StateReader& reader) {
  reader.get(readings_);
  for (DelayLine& line : lines_) line.load(reader);
  for (LastMotion& last : last_) {
    reader.get(std::span(last.velocity.data(), 3));
    last.time = reader.get();
  }
}

std::size_t SensorBank::delays_size() const {
  std::size_t size = 0;
  for (const DelayLine& line : lines_) size += line.size();
  return size;
}

}  // namespace lacuna::simulation
