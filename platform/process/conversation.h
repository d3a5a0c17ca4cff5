#pragma once

#include "process/child_lines.h"
#include "process/outside_trial.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lacuna {

/// Control periods that end within a test of that duration (s).
std::size_t whole_periods(double duration, double period);

/// One test as it is spoken of: sent, carried out by the target, and heard of.
class Conversation {
 public:
  /// All of these must live as long. `until`: when it must be over.
  Conversation(ChildLines& lines, const Hello& hello, const TestSpace& space, const TestHeading& heading,
               ChildLines::Clock::time_point until);

  /// A series goes out whole where the target takes it so, else with a controller's commands period by period. What
  /// starts elsewhere than at rest in the zero configuration is refused. Throws `Error`.
  Trial carry_out(const Test& test);
  /// What the target said of its start.
  const JointStarts& start() const { return start_; }
  /// What a user should know, a sentence each.
  std::vector<std::string> notes() const;

 private:
  Trial whole(const CommandSeries& commands);
  template <class Drive>
  Trial period_by_period(Drive&& drive);
  void clip(std::vector<double>& commands);
  Readings next_readings(std::size_t period, double before);

  ChildLines& lines_;
  const Hello& hello_;
  const TestSpace& space_;
  const TestHeading& heading_;
  ChildLines::Clock::time_point until_;
  ChannelOrder order_;
  JointStarts start_;
  std::vector<std::size_t> clipped_;  ///< how many commands of each of the target's actuators
};

}  // namespace lacuna
