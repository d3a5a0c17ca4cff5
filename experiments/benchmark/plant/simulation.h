#pragma once

#include "plant/law.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace hidden_effects {

using Laws = std::vector<std::shared_ptr<const Law>>;  // shared: cases, fits and their copies hold the same laws

/// Commands held between samples, and random forces that are linear between knots.
struct Excitation {
  double interval = 0.005;                    ///< s, between samples
  std::vector<std::vector<double>> commands;  ///< by drive, one a sample
  double knot_interval = 0.001;               ///< s
  std::vector<std::vector<double>> forces;    ///< by joint, one a knot, N·m or N; empty: none
  std::size_t samples() const { return commands.empty() ? 0 : commands.front().size(); }
};

/// Where the plant is, whole: copying and restoring it goes on as if nothing had been.
struct PlantState {
  Coordinates position, velocity, acceleration;
  std::array<double, 32> memory{};  ///< of the laws, in their order
};

/// A plant under an excitation. The integration is a time-stepping scheme of second order: positions move half a step,
/// velocities a whole one by the forces there, with dry friction as a bounded impulse that brings the velocity to zero
/// where it can (J. J. Moreau, "Unilateral contact and dry friction in finite freedom dynamics", 1988) and changes its
/// sign at the instant of a reversal, positions another half. `step` has to divide the sample interval.
class Simulation {
 public:
  /// `excitation` has to outlive it. Throws `std::invalid_argument` for a step that does not divide the sample
  /// interval.
  Simulation(PlantSpec spec, Laws laws, const Excitation& excitation, double step);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Rotors begin where their joints are.
  PlantState start(const Coordinates& joint_positions, const Coordinates& joint_velocities) const;

  /// Carries `state` on from sample `from` to the next; calls `at_step(state)` after each integration step.
  template <class AtStep>
  void advance(PlantState& state, std::size_t from, const AtStep& at_step) {
    for (int k = 0; k < steps_a_sample_; ++k) {
      take_step(state, (static_cast<double>(from) * steps_a_sample_ + k) * step_);
      at_step(state);
    }
  }

  const PlantSpec& spec() const { return spec_; }
  const Laws& laws() const { return laws_; }
  int coordinates() const { return coordinates_; }
  int steps_a_sample() const { return steps_a_sample_; }
  double step() const { return step_; }

 private:
  void take_step(PlantState& state, double time);
  double mean_command(std::size_t drive, double from) const;
  double random_force(std::size_t joint, double time) const;
  void add_joint_forces(const Moment& at, double time, Load& load) const;
  void add_drive_forces(const Moment& at, double time, double* memory, Load& load);
  void brake(const Load& load, const Coordinates& from, Coordinates& velocity) const;

  PlantSpec spec_;
  Laws laws_;
  const Excitation* excitation_;
  double step_;
  int steps_a_sample_;
  int coordinates_;
  std::vector<int> rotor_of_drive_;  ///< its coordinate, −1 where rigid
  std::vector<int> memory_of_law_;
  Chain chain_;
  Coordinates drive_;
  CoordinateMatrix inertia_, mobility_;
};

}  // namespace hidden_effects
