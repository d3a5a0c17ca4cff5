#include "simulation/robot_problems.h"

#include "foundation/text/problem.h"
#include "simulation/shared/joint_tree.h"
#include "simulation/shared/robot_checks.h"

namespace lacuna {
namespace {

template <class Check>
void collect(Check&& check, std::vector<std::string>& sentences) {
  try {
    check();
  } catch (const BadInput& error) {
    for (const Problem& problem : error.problems()) sentences.push_back(problem.message);
  }
}

}  // namespace

std::vector<std::string> robot_problems(const RobotSpec& robot) {
  std::vector<std::string> sentences;
  collect([&] { simulation::check_robot(robot); }, sentences);
  collect([&] { simulation::make_joint_tree(robot); }, sentences);
  return sentences;
}

}  // namespace lacuna
