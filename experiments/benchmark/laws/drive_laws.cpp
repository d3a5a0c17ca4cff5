#include "laws/joint_law.h"
#include "laws/law_kind.h"
#include "plant/coordinates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

/// What happens to a command before it is a force. A. Hughes, B. Drury, Electric Motors and Drives, Newnes 2013.
namespace hidden_effects {
namespace {

bool of_force(const PlantSpec& spec, int drive) { return !spec.drives[static_cast<std::size_t>(drive)].servo; }
bool of_rotor(const PlantSpec& spec, int drive) {
  return spec.drives[static_cast<std::size_t>(drive)].rotor_inertia > 0.0;
}

class DriveLaw : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;

  double command(int drive, double value, const Moment& at, double* memory) const final {
    return drive == element_ ? changed(value, at, memory) : value;
  }

 protected:
  PlantDrive& of(PlantSpec& spec) const { return spec.drives[static_cast<std::size_t>(element_)]; }
  virtual double changed(double value, const Moment&, double* /*memory*/) const { return value; }
};

class DriveDelay : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  void amend(PlantSpec& spec) const override { of(spec).delay += p_[0]; }
};

/// A bus that is busy now and then: each stretch of 20 ms is late by a share of its own, 0 to twice the mean.
class JitteredDelay : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  double lateness(int drive, double time) const override {
    if (drive != element_) return 0.0;
    auto bits = static_cast<std::uint64_t>(std::max(0.0, time) / 0.02) + 0x9E3779B97F4A7C15ull;
    for (int k = 0; k < 3; ++k) {
      bits ^= bits >> 31;
      bits *= 0xBF58476D1CE4E5B9ull;
    }
    return p_[0] * 2.0 * static_cast<double>(bits >> 11) * 0x1.0p-53;
  }
};

class DriveOffset : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  void amend(PlantSpec& spec) const override { of(spec).offset += p_[0]; }
};

class Gain : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  void amend(PlantSpec& spec) const override { of(spec).gain *= p_[0]; }
};

class DriveSaturation : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  void amend(PlantSpec& spec) const override { of(spec).limit = std::min(of(spec).limit, p_[0]); }
};

class DeadZone : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;

 protected:
  double changed(double u, const Moment&, double*) const override { return u - std::clamp(u, -p_[0], p_[0]); }
};

/// An amplifier whose small signals are weak, without a corner: u³/(u² + width²).
class SoftDeadZone : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;

 protected:
  double changed(double u, const Moment&, double*) const override { return u * u * u / (u * u + p_[0] * p_[0]); }
};

/// Memory: the output, and whether there is one yet.
class DriveLag : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  int memory_size() const override { return 2; }

 protected:
  double changed(double u, const Moment& at, double* memory) const override {
    if (memory[1] == 0.0) memory[0] = u;
    memory[1] = 1.0;
    const double half = std::exp(-0.5 * at.step / p_[0]);
    const double middle = u + (memory[0] - u) * half;
    memory[0] = u + (middle - u) * half;
    return middle;
  }
};

/// Two lags of half the time, one behind the other: a current loop with its filter.
class TwofoldLag : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  int memory_size() const override { return 3; }

 protected:
  double changed(double u, const Moment& at, double* memory) const override {
    if (memory[2] == 0.0) memory[0] = memory[1] = u;
    memory[2] = 1.0;
    const double decay = std::exp(-2.0 * at.step / p_[0]);
    const double before = memory[0];
    memory[0] = u + (memory[0] - u) * decay;
    const double fed = 0.5 * (before + memory[0]), last = memory[1];
    memory[1] = fed + (memory[1] - fed) * decay;
    return 0.5 * (last + memory[1]);
  }
};

class SlewLimit : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  int memory_size() const override { return 2; }

 protected:
  double changed(double u, const Moment& at, double* memory) const override {
    if (memory[1] == 0.0) memory[0] = u;
    memory[1] = 1.0;
    const double most = p_[0] * at.step, before = memory[0];
    memory[0] += std::clamp(u - memory[0], -most, most);
    return 0.5 * (before + memory[0]);
  }
};

class SpeedLine : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;

 protected:
  double changed(double u, const Moment& at, double*) const override {
    const int joint = at.spec.drives[static_cast<std::size_t>(element_)].joint;
    const double speed = at.velocity[joint] / p_[1];
    return std::clamp(u, -p_[0] * (1.0 + speed), p_[0] * (1.0 - speed));
  }
};

/// Memory: how much weaker the motor is.
class Fade : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  int memory_size() const override { return 1; }

 protected:
  double changed(double u, const Moment& at, double* heat) const override {
    *heat += at.step * (p_[0] * u * u - *heat) / p_[1];
    return u / (1.0 + *heat);
  }
};

class Compliance : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  void amend(PlantSpec& spec) const override {
    of(spec).elastic = true;
    of(spec).stiffness = p_[0];
    of(spec).damping = p_[1];
  }
};

class Backlash : public DriveLaw {
 public:
  using DriveLaw::DriveLaw;
  void amend(PlantSpec& spec) const override {
    of(spec).elastic = true;
    of(spec).gap = p_[0];
    of(spec).stiffness = p_[1];
    of(spec).damping = p_[2];
  }
};

/// Of rotor and load against each other.
double reduced_inertia(const Scales& at) { return 1.0 / (1.0 / at.rotor + 1.0 / at.inertia); }

}  // namespace

std::vector<LawKind> drive_laws() {
  return {
      {"command_delay",
       "command_delay",
       Place::drive,
       true,
       {"delay"},
       make<DriveDelay>,
       [](double size, const Scales&, const Shape&) { return Values{std::clamp(0.01 * size, kSample, 0.5)}; },
       everywhere},
      {"jittered_delay",
       "command_delay",
       Place::drive,
       false,
       {"delay"},
       make<JitteredDelay>,
       [](double size, const Scales&, const Shape&) { return Values{std::clamp(0.01 * size, kSample, 0.5)}; },
       everywhere},
      {"command_offset",
       "command_offset",
       Place::drive,
       true,
       {"offset"},
       make<DriveOffset>,
       [](double size, const Scales& at, const Shape& u) { return Values{with_sign(0.1 * size * at.command, u[0])}; },
       everywhere},
      {"actuator_lag",
       "actuator_lag",
       Place::drive,
       true,
       {"time"},
       make<DriveLag>,
       [](double size, const Scales&, const Shape&) { return Values{std::clamp(0.01 * size, kSample, 2.0)}; },
       everywhere},
      {"twofold_lag",
       "actuator_lag",
       Place::drive,
       false,
       {"time"},
       make<TwofoldLag>,
       [](double size, const Scales&, const Shape&) { return Values{std::clamp(0.01 * size, kSample, 2.0)}; },
       everywhere},
      {"slew_rate_limit",
       "slew_rate_limit",
       Place::drive,
       true,
       {"rate"},
       make<SlewLimit>,
       [](double size, const Scales& at, const Shape&) {  // a step of the command takes this long: one that is shorter
                                                          // than a sample would hide between two
         return Values{at.peak_command / (kSample + 0.03 * size)};
       },
       everywhere},
      {"torque_saturation",
       "torque_saturation",
       Place::drive,
       true,
       {"limit"},
       make<DriveSaturation>,
       [](double size, const Scales& at, const Shape&) { return Values{at.peak_force / (1.0 + 0.3 * size)}; },
       everywhere},
      {"torque_gain",
       "torque_gain",
       Place::drive,
       true,
       {"gain"},
       make<Gain>,
       [](double size, const Scales&, const Shape& u) {
         return Values{u[0] < 0.5 ? 1.0 / (1.0 + 0.1 * size) : 1.0 + 0.1 * size};
       },
       everywhere},
      {"dead_zone",
       "dead_zone",
       Place::drive,
       true,
       {"width"},
       make<DeadZone>,
       [](double size, const Scales& at, const Shape&) { return Values{0.05 * size * at.command}; },
       of_force},
      {"soft_dead_zone",
       "dead_zone",
       Place::drive,
       false,
       {"width"},
       make<SoftDeadZone>,
       [](double size, const Scales& at, const Shape&) { return Values{0.1 * size * at.command}; },
       of_force},
      {"torque_speed_line",
       "torque_speed_line",
       Place::drive,
       true,
       {"stall", "no_load"},
       make<SpeedLine>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{at.peak_force * between(1.0, 1.5, u[0]) / (1.0 + 0.15 * size),
                       at.velocity * between(2.0, 3.0, u[1]) / (1.0 + 0.15 * size)};
       },
       of_force},
      {"thermal_fade",
       "thermal_fade",
       Place::drive,
       true,
       {"fade", "time"},
       make<Fade>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.2 * size / (at.command * at.command), between(0.4, 2.0, u[0]) * at.duration};
       },
       of_force},
      {"joint_compliance",
       "joint_compliance",
       Place::drive,
       true,
       {"stiffness", "damping"},
       make<Compliance>,
       [](double size, const Scales& at, const Shape& u) {
         const double rate = kTurn * between(20.0, 30.0, u[0]) / std::sqrt(size), reduced = reduced_inertia(at);
         return Values{reduced * rate * rate, 2.0 * between(0.02, 0.08, u[1]) * reduced * rate};
       },
       of_rotor},
      {"backlash",
       "backlash",
       Place::drive,
       true,
       {"gap", "stiffness", "damping"},
       make<Backlash>,
       [](double size, const Scales& at, const Shape& u) {
         const double rate = kTurn * between(60.0, 90.0, u[0]), reduced = reduced_inertia(at);
         return Values{0.02 * size * at.position, reduced * rate * rate, 2.0 * 0.2 * reduced * rate};
       },
       of_rotor},
  };
}

}  // namespace hidden_effects
