#include "loading/effect_trial.h"
#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/exercises/robot_writing.h"
#include "simulation/robot_problems.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

class RobotExercise : public Exercise {
 public:
  explicit RobotExercise(const RobotDefinition& robot) : robot_(robot) {}

  ParameterDeclarations declared() const override { return robot_.parameters(); }
  void go(const Setting& setting, Transcript& transcript) const override {
    write_down_robot("build", robot_.build({setting, &declared_}), transcript);
  }
  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    for (const std::string& problem : robot_problems(robot_.build({settings().front(), &declared_})))
      broken.push_back("no engine can simulate the robot of the defaults: " + problem);
    return broken;
  }
  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    return {repeated_call("build", true, 20, [&] { robot_.build({setting, &declared_}); })};
  }

 private:
  const RobotDefinition& robot_;
  const RobotSpec declared_ = two_links();
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const RobotDefinition& robot, const ExerciseInputs&) {
  return std::make_unique<RobotExercise>(robot);
}

}  // namespace lacuna
