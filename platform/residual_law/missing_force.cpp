#include "residual_law/missing_force.h"

#include "foundation/effect_at_place.h"
#include "residual_law/joint_laws.h"

#include <algorithm>
#include <optional>
#include <set>

namespace lacuna {
namespace {

constexpr std::size_t kMostJoints = 3;  ///< that are drawn

/// The joint on which an element of the robot acts, without "joint."; empty: it may be any.
std::string joint_at(const RobotSpec& robot, const std::string& place) {
  const std::string name = place.substr(place.find('.') + 1);
  if (place.starts_with("joint.")) return name;
  if (place.starts_with("actuator."))
    for (const ActuatorSpec& actuator : robot.actuators)
      if (actuator.name == name) return actuator.joint;
  if (place.starts_with("body."))
    for (const JointSpec& joint : robot.joints)
      if (joint.child == name) return joint.name;
  return "";
}

std::vector<JointCourse> courses_of_answer(const SearchResult& found) {
  const RobotSpec& robot = found.data->plain().definition.structure.robot;
  std::set<std::string> joints;
  for (const std::string& member : found.answer().judged.members)
    joints.insert(joint_at(robot, effect_at_place_from(member).place));
  std::vector<JointCourse> courses = joint_courses(*found.data);
  if (!joints.contains(""))
    std::erase_if(courses, [&](const JointCourse& course) { return !joints.contains(course.joint); });
  courses.resize(std::min(courses.size(), kMostJoints));
  return courses;
}

/// A fitted model linearised on a ladder, at its values and initial states.
std::optional<LinearPrediction> linearised(const SearchData& data, const PredictionLadder& ladder,
                                           const FittedModel& model) {
  const ModelContext context = data.bench_for(model.model);
  LadderPredictions predictions(ladder, context.predictor(), context.space(), data.starts(),
                                changes_readings(model.model.definition));
  return predictions.linearise(model.fit.point);
}

/// The model as it is, with only that part of its residuals that the answer removes.
LinearPrediction answers_part(const LinearPrediction& base, const LinearPrediction& answer) {
  LinearPrediction part = base;
  for (std::size_t k = 0; k < part.stretches.size(); ++k) part.stretches[k].residual -= answer.stretches[k].residual;
  return part;
}

}  // namespace

std::vector<ForceCurve> missing_force(const SearchResult& found) {
  const SearchData& data = *found.data;
  if (found.decision.answer == 0 || data.plain().definition.structure.robot.contact.ground) return {};
  const PredictionLadder& ladder = found.by_all_lengths ? data.ladder() : data.deciding();
  const FittedModel& model = found.sets.front();
  const std::optional<LinearPrediction> base = linearised(data, ladder, model);
  const std::optional<LinearPrediction> answer = linearised(data, ladder, found.answer());
  if (!base || !answer) return {};
  const LinearPrediction part = answers_part(*base, *answer);
  std::vector<ForceCurve> all;
  for (const JointCourse& course : courses_of_answer(found))
    for (ForceCurve& curve : JointLaws(data, model, ladder, *base, course).curves_beside(part))
      all.push_back(std::move(curve));
  return all;
}

}  // namespace lacuna
