#include "residual_law/joint_course.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using Memories = std::array<double, kMemories>;

const ActuatorSpec* actuator_of(const RobotSpec& robot, const std::string& joint) {
  const auto found = std::find_if(robot.actuators.begin(), robot.actuators.end(),
                                  [&](const ActuatorSpec& one) { return one.joint == joint; });
  return found == robot.actuators.end() ? nullptr : &*found;
}

/// A recorded command over time, held from row to row.
class HeldCommand {
 public:
  HeldCommand(const Trial& trial, const std::string& actuator) : series_(trial.commands.series) {
    for (std::size_t c = 0; c < series_.channels.size(); ++c)
      if (series_.channels[c].name == actuator) column_ = static_cast<Eigen::Index>(c);
  }
  double at(double time) const {
    if (column_ < 0 || series_.times.size() == 0) return 0.0;
    const double* begin = series_.times.data();
    const Eigen::Index after = std::upper_bound(begin, begin + series_.times.size(), time) - begin;
    return series_.samples(std::max<Eigen::Index>(0, after - 1), column_);
  }
  std::string unit() const { return column_ < 0 ? "" : series_.channels[static_cast<std::size_t>(column_)].unit; }

 private:
  const TimeSeries& series_;
  Eigen::Index column_ = -1;
};

double direction(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

void remember(std::vector<JointMoment>& moments, const Memories& constants) {
  for (std::size_t i = 0; i < moments.size(); ++i)
    for (std::size_t m = 0; m < kMemories; ++m) {
      const double kept = i == 0 ? 0.0 : std::exp(-(moments[i].time - moments[i - 1].time) / constants[m]);
      const auto mix = [&](double before, double now) { return kept * before + (1.0 - kept) * now; };
      const JointMoment& before = moments[i == 0 ? 0 : i - 1];
      moments[i].slow_velocity[m] = mix(before.slow_velocity[m], moments[i].velocity);
      moments[i].slow_direction[m] = mix(before.slow_direction[m], direction(moments[i].velocity));
      moments[i].slow_command[m] = mix(before.slow_command[m], moments[i].command);
    }
}

std::vector<JointMoment> moments_of(const SearchData& data, std::size_t trial, int coordinate,
                                    const HeldCommand& command) {
  const Eigen::VectorXd& times = data.task().trials[trial].measured.times;
  const int coordinates = data.starts().states().coordinates();
  std::vector<JointMoment> moments;
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    const StartState state = data.starts().at(trial, i).start;
    moments.push_back({.position = component(state, coordinate),
                       .velocity = component(state, coordinates + coordinate),
                       .command = command.at(times(i)),
                       .time = times(i) - times(0)});
  }
  return moments;
}

JointCourse course_of(const SearchData& data, const JointSpec& joint, int coordinate, const Memories& constants) {
  const bool turns = joint.kind == JointKind::hinge;
  JointCourse course{joint.name, turns ? "rad" : "m", turns ? "N*m" : "N", "", {}};
  const ActuatorSpec* actuator = actuator_of(data.plain().definition.structure.robot, joint.name);
  const std::vector<Trial>& trials = data.task().trials;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    course.trials.emplace_back();
    if (trials[t].held_out) continue;
    const HeldCommand command(trials[t], actuator ? actuator->name : "");
    if (course.command_unit.empty()) course.command_unit = command.unit();
    course.trials.back() = moments_of(data, t, coordinate, command);
    remember(course.trials.back(), constants);
  }
  return course;
}

}  // namespace

std::vector<double> JointCourse::all(double JointMoment::*quantity) const {
  std::vector<double> values;
  for (const std::vector<JointMoment>& moments : trials)
    for (const JointMoment& moment : moments) values.push_back(moment.*quantity);
  return values;
}

std::vector<JointCourse> joint_courses(const SearchData& data) {
  const RobotSpec& robot = data.plain().definition.structure.robot;
  const std::vector<Coordinate>& coordinates = data.plain().model->coordinates();
  const std::vector<double>& lengths = data.ladder().lengths;
  const Memories constants = {lengths.front(), std::sqrt(lengths.front() * lengths.back()), lengths.back()};
  std::vector<JointCourse> courses;
  for (const JointSpec& joint : robot.joints) {
    if (joint.kind != JointKind::hinge && joint.kind != JointKind::slider) continue;
    const auto found = std::find_if(coordinates.begin(), coordinates.end(),
                                    [&](const Coordinate& one) { return one.name == "joint." + joint.name; });
    if (found == coordinates.end()) continue;
    const auto coordinate = static_cast<int>(found - coordinates.begin());
    if (data.starts().states().position_reading(0, coordinate))
      courses.push_back(course_of(data, joint, coordinate, constants));
  }
  return courses;
}

}  // namespace lacuna
