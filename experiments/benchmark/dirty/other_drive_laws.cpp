#include "dirty/other_laws.h"
#include "laws/joint_law.h"

#include <algorithm>
#include <cmath>

/// What motors and amplifiers do to a command. A. Hughes, B. Drury, Electric Motors and Drives, Newnes 2013.
namespace hidden_effects::dirty {
namespace {

bool by_force(const PlantSpec& spec, int drive) { return !spec.drives[static_cast<std::size_t>(drive)].servo; }

/// A torque constant that falls with the current as the iron saturates: u/(1 + (u/level)²)^½.
class SaturatingIron : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  double command(int drive, double u, const Moment&, double*) const override {
    return drive == element_ ? u / std::sqrt(1.0 + u * u / (p_[0] * p_[0])) : u;
  }
};

/// A drive of second order: a current loop or a valve that overshoots. Memory: output, its rate, whether it has begun.
class SecondOrderLag : public ElementLaw {
 public:
  using ElementLaw::ElementLaw;
  int memory_size() const override { return 3; }
  double command(int drive, double u, const Moment& at, double* memory) const override {
    if (drive != element_) return u;
    if (memory[2] == 0.0) memory[0] = u;
    memory[2] = 1.0;
    const double rate = 2.0 * p_[1] / p_[0], h = at.step, before = memory[0];
    const double pull = rate * rate * (u - memory[0]);
    memory[1] = (memory[1] + h * pull) / (1.0 + 2.0 * p_[1] * rate * h + rate * rate * h * h);
    memory[0] += h * memory[1];
    return 0.5 * (before + memory[0]);
  }
};

}  // namespace

std::vector<LawKind> other_drive_laws() {
  return {
      {"saturating_iron",
       "supply_sag",
       Place::drive,
       false,
       {"level"},
       make<SaturatingIron>,
       [](double size, const Scales& at, const Shape&) { return Values{at.peak_command / std::sqrt(0.3 * size)}; },
       by_force},
      {"second_order_lag",
       "actuator_lag",
       Place::drive,
       false,
       {"time", "damping_ratio"},
       make<SecondOrderLag>,
       [](double size, const Scales& at, const Shape& u) {
         return Values{0.06 * size * at.position / at.velocity, between(0.4, 0.8, u[0])};
       },
       everywhere},
  };
}

}  // namespace hidden_effects::dirty
