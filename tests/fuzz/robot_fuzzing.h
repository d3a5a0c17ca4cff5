#pragma once

#include "fuzzing.h"

#include <lacuna/robot_format.h>

#include <cmath>
#include <set>

namespace lacuna::fuzz {

/// An input is a robot file and, behind a line "---", one that it may include as "part.xml".
class FuzzedFiles : public FilesBeside {
 public:
  explicit FuzzedFiles(const std::string& input) : text(input.substr(0, input.find(kBetween))) {
    if (text.size() < input.size()) part_ = input.substr(text.size() + kBetween.size());
  }
  std::optional<std::string> text_of(const std::string& path) const override {
    return path == "part.xml" ? part_ : std::nullopt;
  }
  RobotText file(const std::string& name, RobotBase base = RobotBase::as_written) const {
    return {name, text, base, this};
  }

  const std::string text;

 private:
  static constexpr std::string_view kBetween = "\n---\n";
  std::optional<std::string> part_;
};

inline void require_sentences(const ReadRobot& read) {
  for (const RobotRemark& remark : read.remarks) require(!remark.text.empty(), "a remark has a sentence");
  for (const RobotFileProblem& problem : read.problems) require(!problem.text.empty(), "a problem has a sentence");
}

/// A robot without problems can be simulated: its bodies have mass, and joints hold those that it has.
inline void require_whole(const RobotSpec& robot) {
  std::set<std::string> bodies = {kWorld}, joints;
  for (const BodySpec& body : robot.bodies) {
    require(body.mass > 0.0 && std::isfinite(body.mass), "a body has mass");
    require(body.inertia.xx > 0.0 && std::isfinite(body.inertia.xx + body.inertia.yy + body.inertia.zz),
            "a body has inertia");
    require(body.position.allFinite() && body.com.allFinite(), "a body is somewhere");
    require(std::abs(body.orientation.norm() - 1.0) < 1e-6, "a body is turned by a rotation");
    require(bodies.insert(body.name).second, "a body has a name of its own");
  }
  for (const JointSpec& joint : robot.joints) {
    require(bodies.contains(joint.parent) && bodies.contains(joint.child), "a joint holds bodies");
    require(std::abs(joint.axis.norm() - 1.0) < 1e-6, "an axis has a direction");
    require(joint.lower < joint.upper, "stops are in order");
    require(joints.insert(joint.name).second, "a joint has a name of its own");
  }
  for (const ActuatorSpec& actuator : robot.actuators)
    require(joints.contains(actuator.joint), "a motor drives a joint");
}

/// What is read is whole, and what is written of it, into the file and anew, is read.
inline void require_way_back(const RobotFormat& format, const FuzzedFiles& files, const RobotText& file) {
  const ReadRobot read = format.read(file);
  require_sentences(read);
  if (!read.problems.empty()) return;
  require_whole(read.robot);
  for (const bool into_file : {true, false}) {
    RobotToWrite robot{read.robot, std::nullopt, "fuzzed -- <twice>"};
    if (into_file) robot.original = file;
    const WrittenRobot written = format.write(robot);
    if (!written.problems.empty()) continue;
    const RobotBase base = into_file ? file.base : RobotBase::as_written;  // a new file says itself what floats
    const ReadRobot again = format.read({file.name, written.text, base, &files});
    for (const RobotFileProblem& problem : again.problems) std::fprintf(stderr, "%s\n", problem.text.c_str());
    require(again.problems.empty(), "a robot that is written is read");
  }
}

}  // namespace lacuna::fuzz
