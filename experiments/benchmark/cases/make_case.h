#pragma once

#include "cases/case_plan.h"
#include "refit/plant_fit.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// A trial as it was and as it was recorded.
struct MadeTrial {
  std::string name;
  bool held_out = false;
  Excitation applied;                                  ///< true commands and random forces
  std::vector<std::vector<double>> recorded_commands;  ///< by drive; with noise where the case has it
  Readings readings;                                   ///< as recorded
  Readings clean;                                      ///< of the same plant without random force or noise

  FittedTrial fitted() const;      ///< recorded commands and readings
  FittedTrial noise_free() const;  ///< true commands without random force, clean readings
};

/// The standard deviations that a case's noise was made with, SI.
struct CaseNoise {
  std::vector<double> sensor_white, sensor_slow, quantum;  ///< by sensor
  double sensor_time = 0.03;                               ///< s, correlation of the slow part
  std::vector<double> random_force;                        ///< by joint
  double force_time = 0.05;                                ///< s
  std::vector<double> command;                             ///< by drive, white from sample to sample
};

/// A case with its truth.
struct MadeCase {
  CasePlan plan;
  PlantModel base;               ///< what the user believes: laws empty, free values nominal
  PlantModel truth;              ///< the same with the hidden laws
  Eigen::VectorXd base_values;   ///< true ones of the base
  Eigen::VectorXd truth_values;  ///< base_values, then the hidden laws' parameters
  CaseNoise noise;
  std::vector<MadeTrial> trials;  ///< fit trials, then held-out ones
  double strength = 1.0;          ///< as it came out: RMSE of the refitted base over that of the refitted truth
  bool absorbed = false;          ///< the base explains it: nothing is missing in these data
  std::vector<double> base_rms, truth_rms;  ///< by sensor, of the two refits, over the fit trials
};

/// Throws `std::runtime_error` where the plan cannot be carried out, with the reason.
MadeCase make_case(const CasePlan& plan);

}  // namespace hidden_effects
