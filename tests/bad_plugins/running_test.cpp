#include "bad_plugins/bad_folder.h"
#include "evaluation/model/model_definition.h"

#include <gmock/gmock.h>

#include <cmath>

/// Components that misbehave while a model is made from them or runs: a sentence that names component,
/// file and what to do, and the host goes on.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kEnd = 0.2;    // s
constexpr double kStep = 0.01;  // s

/// A wheel on a hinge with a motor and a sensor.
RobotSpec wheel() {
  RobotSpec robot;
  robot.name = "wheel";
  robot.bodies.resize(1);
  robot.bodies[0].name = "disc";
  robot.joints.resize(1);
  robot.joints[0].name = "axle";
  robot.joints[0].child = "disc";
  robot.actuators.resize(1);
  robot.actuators[0].name = "motor";
  robot.actuators[0].joint = "axle";
  robot.sensors.resize(1);
  robot.sensors[0].name = "angle";
  robot.sensors[0].element = "axle";
  return robot;
}

class BadComponent : public testing::Test {
 protected:
  BadComponent() {
    experiment_.file = "rig.toml";
    experiment_.model.robot = "declared";
    experiment_.model.declared = wheel();
    experiment_.engine.step = kStep;
  }

  /// The wheel's model with this effect, its plugin in `library`.
  ModelDefinition define(const std::string& library, const std::string& effect, std::vector<std::string> where) {
    const BadFolder folder(library);
    experiment_.model.effects = {{effect, effect, std::move(where), {}, {}}};
    return define_model(experiment_, PluginCatalog({built_plugins(), folder.path()}));
  }
  ModelDefinition define_robot(const std::string& library, const std::string& robot) {
    const BadFolder folder(library);
    experiment_.model.robot = robot;
    return define_model(experiment_, PluginCatalog({built_plugins(), folder.path()}));
  }

  static SimulationResult run(const CompiledModel& model) {
    lacuna::Test test;
    test.drive = CommandSeries{};
    std::vector<double> times;
    for (double time = 0.0; time < kEnd; time += kStep) times.push_back(time);
    SimulationOptions options;
    options.end_time = kEnd;
    options.output_times = times;
    SimulationResult result;
    model.simulate({}, test, options, *model.make_workspace(), result);
    return result;
  }

  /// Expects that the run becomes invalid at the effect's onset, with these words.
  void expect_invalid(const std::string& library, const std::string& effect, std::vector<std::string> where,
                      const std::string& words, const std::string& what_to_do) {
    const ModelDefinition model = define(library, effect, std::move(where));
    const auto compiled = compile(model.structure, model.engine);
    const SimulationResult result = run(*compiled);
    EXPECT_EQ(result.ending, Ending::invalid);
    EXPECT_THAT(result.reason, AllOf(HasSubstr("at 0.0"), HasSubstr(effect), HasSubstr(library + ".so"),
                                     HasSubstr(words), HasSubstr(what_to_do)));
    EXPECT_TRUE(std::isfinite(result.readings.samples(2, 0))) << "before the onset all is well";
    EXPECT_TRUE(std::isnan(result.readings.samples.bottomRows(1)(0, 0)));
  }

  Experiment experiment_;
};

TEST_F(BadComponent, ThatThrowsAForeignTypeInTheMiddleOfARun) {
  expect_invalid("throwing", "throws_in_step", {"joint.axle"}, "an object of type rig::Trouble", "repair it");
  expect_invalid("throwing", "throws_in_sense", {"sensor.angle"}, "an object of type int", "repair it");
}

TEST_F(BadComponent, ThatReturnsNotANumberInTheMiddleOfARun) {
  expect_invalid("not_a_number", "nan_load", {"joint.axle"}, "not finite", "take the effect out");
  expect_invalid("not_a_number", "nan_command", {"actuator.motor"}, "command is not a number", "take the effect out");
  expect_invalid("not_a_number", "nan_reading", {"sensor.angle"}, "reading is not a number", "take the effect out");
}

TEST_F(BadComponent, LeavesOtherModelsAlone) {
  const ModelDefinition bad = define("throwing", "throws_in_step", {"joint.axle"});
  const ModelDefinition good = define("throwing", "harmless", {"joint.axle"});
  const auto bad_model = compile(bad.structure, bad.engine);
  const auto good_model = compile(good.structure, good.engine);
  EXPECT_EQ(run(*bad_model).ending, Ending::invalid);
  EXPECT_EQ(run(*good_model).ending, Ending::completed);
  EXPECT_EQ(run(*bad_model).ending, Ending::invalid);
}

TEST_F(BadComponent, ThatThrowsBeforeARun) {
  EXPECT_THAT([&] { define("throwing", "throws_when_described", {"joint.axle"}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("model.effects[0].effect"), HasSubstr("throwing.so"),
                                            HasSubstr("describe threw an object of type rig::Trouble"))));
  const ModelDefinition sized = define("throwing", "throws_when_sized", {"joint.axle"});
  EXPECT_THAT([&] { compile(sized.structure, sized.engine); },
              ThrowsMessage<Error>(AllOf(HasSubstr("throws_when_sized"), HasSubstr("throwing.so"),
                                         HasSubstr("state_size threw an object of type rig::Trouble"))));
  EXPECT_THAT([&] { define_robot("throwing", "throws_in_build"); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("model.robot"), HasSubstr("robot \"throws_in_build\""),
                                            HasSubstr("throwing.so"), HasSubstr("build threw"))));
}

TEST_F(BadComponent, OfTheWrongSize) {
  for (const char* effect : {"negative_state", "endless_state"}) {
    const ModelDefinition model = define("wrong_size", effect, {"joint.axle"});
    EXPECT_THAT([&] { compile(model.structure, model.engine); },
                ThrowsMessage<Error>(AllOf(HasSubstr(effect), HasSubstr("wrong_size.so"),
                                           HasSubstr("it asks for a state of"), HasSubstr("repair the plugin"))));
  }
  EXPECT_THAT([&] { define("wrong_size", "removes_bodies", {"joint.axle"}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("removes_bodies"), HasSubstr("wrong_size.so"),
                                            HasSubstr("added or removed elements"))));
}

TEST_F(BadComponent, ARobotThatCannotBe) {
  EXPECT_THAT([&] { define_robot("wrong_size", "inconsistent_robot"); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("wrong_size.so"), HasSubstr("is the child of two joints"),
                                            HasSubstr("joint \"three\" is not a joint of the robot"))));
  EXPECT_THAT(
      [&] { define_robot("not_a_number", "nan_robot"); },
      ThrowsMessage<BadInput>(AllOf(HasSubstr("not_a_number.so"), HasSubstr("body \"ghost\": its mass is nan"))));
}

TEST_F(BadComponent, DeclarationsWithoutNumbersAreTheFaultOfThePlugin) {
  EXPECT_THAT([&] { define("not_a_number", "nan_default", {"joint.axle"}); },
              ThrowsMessage<BadInput>(
                  AllOf(HasSubstr("nan_default"), HasSubstr("not_a_number.so"), HasSubstr("fault of the plugin"))));
}

}  // namespace
}  // namespace lacuna
