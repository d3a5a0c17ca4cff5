#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/test.h>

#include <vector>

namespace lacuna::simulation {

/// A command series for the actuators: values and means over a range of time, queried with ascending times per
/// actuator. The cursors only speed up the search and never change a result.
class RecordedCommands {
 public:
  /// `commands` must outlive the use. An actuator without a channel gets 0. Throws `Error` for a channel without the
  /// name of an actuator and for an empty series; the times must ascend.
  void open(const CommandSeries& commands, const RobotSpec& robot);

  double at(std::size_t actuator, double time);
  /// Mean over [from, to], from < to; makes predictions continuous in a delay.
  double mean(std::size_t actuator, double from, double to);

 private:
  /// Segment i lies between samples i and i+1; −1 before the first sample, the last one after it.
  std::ptrdiff_t find_segment(std::size_t actuator, double time);
  double value_in(std::ptrdiff_t segment, int column, double time) const;
  double mean_in(std::ptrdiff_t segment, int column, double from, double to) const;
  double end_of(std::ptrdiff_t segment) const;

  const CommandSeries* commands_ = nullptr;
  std::vector<int> columns_;             // per actuator, −1: none
  std::vector<std::ptrdiff_t> cursors_;  // per actuator
};

}  // namespace lacuna::simulation
