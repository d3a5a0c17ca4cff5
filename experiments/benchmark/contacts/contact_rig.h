#pragma once

#include "plant/motion.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hidden_effects {

/// How a size ≥ 0, at which 0 changes nothing, becomes a parameter of an effect.
enum class SizeRule {
  grows,   ///< unit·size
  yields,  ///< unit/size: a stiffness, or what holds
  fades,   ///< exp(−unit·size): a factor
};

/// Something that a contact case can hide: a law at a place of the robot.
struct ContactLaw {
  std::string name;       ///< of the effect, or of a form that the library does not have
  std::string effect;     ///< of the library: the answer that is right
  std::string where;      ///< "joint.leg", "actuator.*"; empty: the world
  std::string parameter;  ///< which the size decides
  SizeRule rule = SizeRule::grows;
  double unit = 1.0;        ///< of the parameter, SI
  std::string others = "";  ///< further start values of the effect, as TOML
  double most = 1e9;        ///< the largest value that the parameter may have

  bool library_form() const { return name == effect; }
  double at_size(double size) const;
};

/// A law with its size.
struct SizedContactLaw {
  ContactLaw law;
  double value = 0.0;  ///< of `law.parameter`
};

/// Spring (N/m; infinite: rigid) and damper (N·s/m) of the ground.
struct ContactGround {
  double stiffness, damping;
};

/// A channel of the robot's sensors that is recorded.
struct ContactChannel {
  std::string name, unit;
  double noise = 0.0;  ///< standard deviation of the bench's; 0: a touch sensor
  double quantum = 0.0;

  bool touch() const { return noise == 0.0; }
};

/// An actuator that is commanded.
struct ContactDrive {
  std::string name, unit;
  double command_noise;   ///< RMS of the noise on a recorded command, in the worst case
  double random_command;  ///< RMS of the command that an unmodelled random force on the joint amounts to, likewise
};

/// What the owner knows of a joint at the start: where it stands, at rest.
struct ContactStart {
  std::string joint;
  double position = 0.0;
};

/// Values by drive, or by channel, and sample.
using Samples = std::vector<std::vector<double>>;

/// A robot on the ground as its owner would write it down. Its trials are short, many, and begin at a known state.
struct ContactRig {
  std::string name;
  std::string robot;  ///< text of robot.toml; empty: the robot plugin of that name
  std::vector<ContactStart> starts;
  double interval;  ///< s, between samples
  double step;      ///< s, of the owner's engine
  int substeps;
  double duration;  ///< s, of a trial
  int fit_trials, held_out_trials;
  std::string free;        ///< address of what the owner frees
  double nominal, spread;  ///< of that, and by how large a share the true value may differ
  ContactGround believed, real;
  std::vector<ContactChannel> channels;
  std::vector<ContactDrive> drives;
  std::vector<ContactLaw> laws;
  Samples (*commands)(int samples, std::uint64_t seed) = nullptr;

  int samples() const;  ///< of a trial
};

ContactRig wheeled_base();
ContactRig hopper();
ContactRig quadruped();

const std::vector<ContactRig>& contact_rigs();

/// The one of that name; throws `std::invalid_argument`.
const ContactRig& contact_rig_named(const std::string& name);

/// The law of that name at its place on a rig; throws `std::invalid_argument`.
const ContactLaw& contact_law(const ContactRig& rig, const std::string& name, const std::string& where);

}  // namespace hidden_effects
