#include "fitting/judged_values.h"

namespace lacuna {

double JudgedValues::objective() const {
  return candidate.valid ? candidate.objective / static_cast<double>(candidate.samples) : kInfinity;
}

JudgedValues ValueJudge::judge(std::string name, const std::vector<double>& values) const {
  const Eigen::VectorXd within = space.to_coordinates(values);
  JudgedValues judged{std::move(name), nullptr, {}};
  judged.problem = std::make_unique<ShootingProblem>(
      predictor, space, make_segments(predictor, states, length, space.to_values(within)), noise);
  judged.problem->set_steps(stage.steps());
  // If the start of one trial cannot be simulated with some values, nothing is known for all trials.
  if (judged.problem->segments().size() == stage.segments().size())
    judged.candidate = evaluate(*judged.problem, within, options);
  return judged;
}

}  // namespace lacuna
