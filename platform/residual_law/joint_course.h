#pragma once

#include "search/search_data.h"

#include <array>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr std::size_t kMemories = 3;  ///< time constants

/// State of a joint at one moment according to the readings: the inputs of a nonparametric residual force.
struct JointMoment {
  double position = 0.0;                           ///< rad or m
  double velocity = 0.0;                           ///< rad/s or m/s
  double command = 0.0;                            ///< of the joint's actuator, in its unit
  double time = 0.0;                               ///< s, since its recording began
  std::array<double, kMemories> slow_velocity{};   ///< low-passed, a time constant each
  std::array<double, kMemories> slow_direction{};  ///< the same filters on the sign of the velocity
  std::array<double, kMemories> slow_command{};    ///< the same filters on the command
};

/// The motion of one hinge or slider in all fit trials.
struct JointCourse {
  std::string joint;                             ///< without "joint."
  std::string position_unit;                     ///< rad or m
  std::string force_unit;                        ///< N*m or N
  std::string command_unit;                      ///< of the joint's actuator; empty: the joint has none
  std::vector<std::vector<JointMoment>> trials;  ///< by trial and sample; empty: the trial is held out

  std::vector<double> all(double JointMoment::*quantity) const;
};

/// Of every hinge and slider whose position is read. The time constants are geometric, from the shortest prediction
/// length to the longest.
std::vector<JointCourse> joint_courses(const SearchData& data);

}  // namespace lacuna
