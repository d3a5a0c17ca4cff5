#include "data_checks/feedback_bias.h"

#include "data_checks/recorded_pendulum.h"
#include "measurement/trials/recorded_controller.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kFeedback = 2.0;    // N·m/rad
constexpr double kInertia = 0.0281;  // kg·m², the pendulum's, of which the model knows 0.025 without its armature
constexpr double kDamping = 0.05;    // N·m·s/rad

/// A pendulum held by a controller, whose armature and damping are to be identified.
struct HeldPendulum : RecordedPendulum {
  explicit HeldPendulum(double disturbance, double declared = kFeedback) : RecordedPendulum() {
    const PendulumTruth truth{
        .inertia = kInertia, .damping = kDamping, .feedback = kFeedback, .disturbance = disturbance};
    trials = {recorded(truth, "sine.csv", sine, 15.0, 1), recorded(truth, "multi.csv", multisine, 15.0, 2)};
    definition.free = {{{"joint.hinge.armature", "kg*m^2", 0.0, 0.02, 0.001, Scale::linear}, ""},
                       {{"joint.hinge.damping", "N*m*s/rad", 0.0, 1.0, 0.01, Scale::linear}, ""}};
    for (const FreeValue& value : definition.free)
      definition.structure.parameters.push_back({value.address, value.lower, value.upper});
    model = compile(definition.structure, definition.engine);
    for (Trial& trial : trials) declare_controller(trial, declared);
    options.starts = 1;
    options.segments = {0.5};
  }

  /// The reference is what the command would have been without feedback, as an angle.
  static void declare_controller(Trial& trial, double feedback) {
    TimeSeries references = trial.commands.series;
    references.samples = (trial.commands.series.samples + kFeedback * trial.measured.samples) / kFeedback;
    trial.controller =
        std::make_shared<RecordedController>(std::vector<ControlLaw>{{.proportional = feedback}},
                                             RecordedSignals{references, trial.commands, {0}, trial.measured});
  }

  FitTask task() const { return {definition, *model, trials, options}; }
  double damping(bool closed_loop) const {
    std::vector<Trial> driven = trials;
    for (Trial& trial : driven) trial.closed_loop = closed_loop;
    return fit({definition, *model, driven, options}).values.back().value;
  }

  FitSection options;
};

TEST(FeedbackBias, IsSeenWhereAControllerAnswersADisturbance) {
  const HeldPendulum rig(0.1);
  EXPECT_THAT(feedback_bias(rig.task()), ElementsAre(StartsWith("feedback bias: joint.hinge.")));
  EXPECT_LT(std::abs(rig.damping(true) - kDamping), 0.5 * std::abs(rig.damping(false) - kDamping))
      << "the controller in the loop is the way to the right value";
}

TEST(FeedbackBias, IsNotSeenWithoutADisturbance) {
  EXPECT_THAT(feedback_bias(HeldPendulum(0.0).task()), ElementsAre(HasSubstr("no feedback bias: ")));
}

TEST(FeedbackBias, IsNotTestedWithAControllerThatDidNotMakeTheCommands) {
  EXPECT_THAT(feedback_bias(HeldPendulum(0.0, -kFeedback).task()),
              testing::Each(AllOf(HasSubstr("does not reproduce the recorded commands"), HasSubstr("motor"))));
}

}  // namespace
}  // namespace lacuna
