#include "loading/effect_trial.h"
#include "plugin_checks/exercises/damaged_texts.h"
#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/exercises/robot_writing.h"
#include "simulation/robot_problems.h"

#include <lacuna/error.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kSameMass = 1e-9;  // share
constexpr const char* kRobotFile = "robot";

class RobotFormatExercise : public Exercise {
 public:
  RobotFormatExercise(const RobotFormat& format, const ExerciseInputs& inputs) : format_(format) {
    if (!inputs.sample.empty())
      text_ = text_of_file(inputs.sample);
    else
      text_ = written().text;
  }

  ParameterDeclarations declared() const override { return {}; }

  void go(const Setting&, Transcript& transcript) const override {
    write_down(text_, transcript);
    for (const std::string& text : damaged_texts(text_)) write_down(text, transcript);
    const WrittenRobot made = written();
    transcript.add_text("write", made.text);
    for (const RobotFileProblem& problem : made.problems) transcript.add_text("write", problem.text);
  }

  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    for (const char* nonsense : {"", "nonsense\n"}) {
      const ReadRobot read = format_.read(file_of(nonsense));
      if (read.problems.empty() && !robot_problems(read.robot).empty())
        broken.emplace_back("a text in another format gives no problem; report the line and what to do");
    }
    if (text_.empty()) return broken;
    const ReadRobot read = format_.read(file_of(text_));
    if (!read.problems.empty())
      broken.push_back("a valid file has a problem: " + read.problems.front().text);
    else if (const std::vector<std::string> problems = robot_problems(read.robot); !problems.empty())
      broken.push_back("no engine can simulate the robot of a file: " + problems.front());
    if (const std::string fault = round_trip_fault(); !fault.empty()) broken.push_back(fault);
    return broken;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    if (text_.empty()) return {};
    return {repeated_call("read", true, 5, [&] { format_.read(file_of(text_)); })};
  }

  std::string reservation() const override {
    return text_.empty() ? "no complete file was read, because it cannot write one; name one with --sample FILE" : "";
  }

 private:
  static RobotText file_of(const std::string& text) { return {kRobotFile, text, RobotBase::as_written, nullptr}; }
  WrittenRobot written() const { return format_.write({two_links(), std::nullopt, ""}); }

  void write_down(const std::string& text, Transcript& transcript) const {
    const ReadRobot read = format_.read(file_of(text));
    for (const RobotFileProblem& problem : read.problems) transcript.add_text("read", problem.text);
    for (const RobotRemark& remark : read.remarks) transcript.add_text("read", remark.text);
    if (read.problems.empty()) write_down_robot("read", read.robot, transcript);
  }

  /// Whether masses and names survive writing and reading; nothing where the format cannot write.
  std::string round_trip_fault() const {
    const WrittenRobot made = written();
    if (!made.problems.empty()) return {};
    const RobotSpec robot = two_links();
    const ReadRobot read = format_.read(file_of(made.text));
    if (!read.problems.empty()) return "it cannot read a file that it wrote: " + read.problems.front().text;
    if (read.robot.bodies.size() < robot.bodies.size()) return "bodies are missing after it wrote and read a robot";
    for (const BodySpec& body : robot.bodies) {
      bool found = false;
      for (const BodySpec& other : read.robot.bodies)
        found = found || (other.name == body.name && std::abs(other.mass - body.mass) <= kSameMass * body.mass);
      if (!found) return "the body " + body.name + " has another name or mass after it wrote and read a robot";
    }
    return {};
  }

  const RobotFormat& format_;
  std::string text_;  ///< a complete file; empty: there is none
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const RobotFormat& format, const ExerciseInputs& inputs) {
  return std::make_unique<RobotFormatExercise>(format, inputs);
}

}  // namespace lacuna
