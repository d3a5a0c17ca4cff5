#include "contacts/hopper_plant.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hidden_effects {
namespace {

constexpr double kFoot = 0.6;                        // kg
constexpr double kSpring = 2500.0, kDamping = 15.0;  // N/m, N·s/m, of the leg
constexpr double kGravity = 9.81;                    // m/s²
constexpr double kH = 2e-5;                          // s
constexpr double kStops = 1e-2;                      // m/s, slower impacts do not bounce
constexpr double kHysteresis = 0.5;                  // s/m, of a ground that gives way
constexpr double kFast = 1.0;                        // m/s, an impact of which gives back half of a slow one's share

double sign_of(double speed, double width) { return std::tanh(speed / width); }

/// Heights over the position in which the foot just touches, and their speeds.
class Hopper {
 public:
  explicit Hopper(const HopperTruth& truth)
      : truth_(truth),
        foot_mass_(kFoot + truth.foot_load),
        soft_(std::isfinite(truth.ground_stiffness) || std::isfinite(truth.hertz_stiffness)) {}

  void step(double told) {
    const double leg = leg_force(told), ground = ground_force();
    trunk_speed_ += kH * (leg / truth_.trunk - kGravity);
    foot_speed_ += kH * ((ground - leg) / foot_mass_ - kGravity);
    touches_ = foot_ <= 0.0;
    if (touches_ && !soft_ && foot_speed_ < 0.0)
      foot_speed_ = foot_speed_ < -kStops ? -given_back(-foot_speed_) * foot_speed_ : 0.0;
    trunk_ += kH * trunk_speed_;
    foot_ += kH * foot_speed_;
    if (!soft_) foot_ = std::max(0.0, foot_);
  }

  double length() const { return trunk_ - foot_; }
  double touch() const { return touches_ ? 1.0 : -1.0; }

 private:
  double leg_force(double told) {
    const double wanted = truth_.gain * told;
    motor_ = first_ || truth_.lag <= 0.0 ? wanted : motor_ + (wanted - motor_) * (1.0 - std::exp(-kH / truth_.lag));
    first_ = false;
    const double stretch = trunk_ - foot_, speed = trunk_speed_ - foot_speed_;
    const double friction = truth_.dry * sign_of(speed, 1e-4) + truth_.smooth_dry * sign_of(speed, 0.1) +
                            truth_.viscous_power * std::copysign(std::pow(std::abs(speed), 0.8), speed);
    return motor_ + truth_.leg_force - kSpring * stretch - truth_.cubic_stiffness * stretch * stretch * stretch -
           (kDamping + truth_.viscous) * speed - friction;
  }

  /// Of a ground that gives way (Hunt and Crossley, Journal of Applied Mechanics 42 (1975) 440-445).
  double ground_force() const {
    const double depth = -foot_;
    if (!soft_ || depth <= 0.0) return 0.0;
    const double elastic = std::isfinite(truth_.hertz_stiffness) ? truth_.hertz_stiffness * std::pow(depth, 1.5)
                                                                 : truth_.ground_stiffness * depth;
    return std::max(0.0, elastic * (1.0 - kHysteresis * foot_speed_));
  }

  double given_back(double speed) const {
    return truth_.restitution + truth_.falling_restitution / (1.0 + speed / kFast);
  }

  const HopperTruth& truth_;
  double foot_mass_;
  bool soft_;
  double trunk_ = kHopperDrop, foot_ = kHopperDrop, trunk_speed_ = 0.0, foot_speed_ = 0.0;
  double motor_ = 0.0;
  bool first_ = true, touches_ = false;
};

double held(const std::vector<double>& values, double interval, double time) {
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::clamp(std::floor(time / interval + 1e-6), 0.0, last))];
}

}  // namespace

HopperTruth hopper_truth(const std::vector<SizedContactLaw>& laws, double trunk) {
  static const std::map<std::string, double HopperTruth::*> values = {
      {"restitution", &HopperTruth::restitution},
      {"falling_restitution", &HopperTruth::falling_restitution},
      {"contact_compliance", &HopperTruth::ground_stiffness},
      {"hertz_compliance", &HopperTruth::hertz_stiffness},
      {"viscous_friction", &HopperTruth::viscous},
      {"viscous_power", &HopperTruth::viscous_power},
      {"coulomb_friction", &HopperTruth::dry},
      {"smooth_coulomb", &HopperTruth::smooth_dry},
      {"cubic_stiffness", &HopperTruth::cubic_stiffness},
      {"joint_offset_torque", &HopperTruth::leg_force},
      {"payload", &HopperTruth::foot_load},
      {"actuator_lag", &HopperTruth::lag},
      {"command_delay", &HopperTruth::delay},
      {"torque_gain", &HopperTruth::gain},
      {"sensor_offset", &HopperTruth::length_offset},
      {"sensor_scale", &HopperTruth::length_scale},
      {"sensor_delay", &HopperTruth::length_delay}};
  HopperTruth truth;
  truth.trunk = trunk;
  for (const SizedContactLaw& one : laws)
    if (const auto found = values.find(one.law.name); found != values.end()) truth.*found->second = one.value;
  return truth;
}

Samples hopper_readings(const HopperTruth& truth, const std::vector<double>& motor, double command_interval,
                        double interval, int samples) {
  const auto steps = static_cast<int>(std::lround(interval / kH));
  const auto behind = static_cast<std::size_t>(std::lround(truth.length_delay / kH));
  Hopper hopper(truth);
  Samples readings(2);
  std::vector<double> lengths;
  for (int i = 0; i < samples; ++i) {
    if (lengths.empty()) lengths.push_back(hopper.length());
    const double seen = lengths[lengths.size() - 1 - std::min(behind, lengths.size() - 1)];
    readings[0].push_back(truth.length_scale * seen + truth.length_offset);
    readings[1].push_back(hopper.touch());
    for (int k = 0; k < steps; ++k) {
      hopper.step(held(motor, command_interval, i * interval + k * kH - truth.delay));
      lengths.push_back(hopper.length());
    }
  }
  return readings;
}

}  // namespace hidden_effects
