#include "plugin_checks/exercises/exercises.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace lacuna {
namespace {

constexpr double kUnknownTruth = std::numeric_limits<double>::quiet_NaN();

/// Two parts of a robot, one attached to the other.
RobotSpec two_parts() {
  RobotSpec robot;
  for (const char* name : {"torso", "leg"}) {
    BodySpec& body = robot.bodies.emplace_back();
    body.name = name;
    body.shapes = {{.kind = ShapeKind::cylinder, .size = {0.1, 1.0, 0.0}}};
  }
  JointSpec& joint = robot.joints.emplace_back();
  joint.name = joint.child = "leg";
  joint.parent = "torso";
  joint.anchor = {0.0, 0.0, 0.5};
  return robot;
}

class ObjectiveExercise : public Exercise {
 public:
  explicit ObjectiveExercise(const ObjectiveMetric& metric) : metric_(metric) {
    space_.free = {{"body.torso.mass", "kg", 1.0, 7.0, 2.0, Scale::linear},
                   {"body.leg.mass", "kg", 1.0, 7.0, 2.0, Scale::linear},
                   {"contact.friction", "1", 0.0, 2.0, 1.0, Scale::linear},
                   {"effect.grease.damping", "N*m*s/rad", 0.0, 2.0, 0.5, Scale::linear}};
    space_.effects = {{"grease", true, {3}}};
  }

  ParameterDeclarations declared() const override { return metric_.parameters(); }

  void go(const Setting& setting, Transcript& transcript) const override {
    for (const std::vector<double>& truth : {kTruth, kPartOfTruth})
      for (const ModelProposal& model : {ModelProposal{kTruth}, other_model()})
        for (const ObjectiveScore& score : metric_.score(space_, model, {truth, robot_}, setting)) {
          transcript.add_text("score", score.name + " " + score.unit);
          transcript.add("score", score.value);
        }
  }

  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    const Setting setting = settings().front();
    const std::vector<ObjectiveScore> of_truth = scores({kTruth}, kTruth, setting);
    if (of_truth.empty()) broken.emplace_back("score() has no figure; throw an Error if it cannot compute one");
    if (largest(of_truth) != 0.0) broken.emplace_back("the true values have an error above 0; return 0 for them");
    const std::vector<ObjectiveScore> of_other = scores(other_model(), kTruth, setting);
    if (!(largest(of_other) > 0.0))
      broken.emplace_back("a model with wrong values has the error 0; return one above 0");
    std::set<std::string> names;
    for (const ObjectiveScore& score : of_other) {
      if (score.value < 0.0) broken.push_back("the figure \"" + score.name + "\" is negative; an error must not be");
      if (score.name.empty() || score.unit.empty()) broken.emplace_back("a figure has no name or no unit; name both");
      if (!names.insert(score.name).second) broken.push_back("two figures are called \"" + score.name + "\"");
    }
    ModelProposal without{kTruth};
    without.values[3] = 1.5;
    without.without = {0};
    std::vector<double> truth = kTruth;
    truth[3] = kUnknownTruth;
    if (largest(scores(without, truth, setting)) != 0.0)
      broken.emplace_back(
          "a value counts that the target does not have, or that belongs to an effect the model does not have");
    return broken;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    const ModelProposal model = other_model();
    return {repeated_call("score", true, 50, [&] { scores(model, kTruth, setting); })};
  }

 private:
  std::vector<ObjectiveScore> scores(const ModelProposal& model, const std::vector<double>& truth,
                                     const Setting& setting) const {
    return metric_.score(space_, model, {truth, robot_}, setting);
  }
  static double largest(const std::vector<ObjectiveScore>& scores) {
    double most = 0.0;
    for (const ObjectiveScore& score : scores) most = std::max(most, score.value);
    return most;
  }
  /// Other values, and a robot with its leg at another place.
  ModelProposal other_model() const {
    RobotSpec robot = robot_;
    robot.bodies[1].position.x() += 0.2;
    return {{3.0, 2.0, 1.0, 0.1}, std::make_shared<RobotSpec>(robot)};
  }

  const ObjectiveMetric& metric_;
  const RobotSpec robot_ = two_parts();
  ModelSpace space_{robot_, {}};
  const std::vector<double> kTruth = {2.5, 1.0, 0.8, 0.07}, kPartOfTruth = {2.5, kUnknownTruth, 0.8, 0.07};
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const ObjectiveMetric& metric, const ExerciseInputs&) {
  return std::make_unique<ObjectiveExercise>(metric);
}

}  // namespace lacuna
