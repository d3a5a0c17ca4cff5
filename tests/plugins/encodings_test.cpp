#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kCodeTolerance = 1e-15;  // of a handful of additions of order one

TEST(ParametersEncoding, AGeneIsAValueUnderItsAddress) {
  const RobotSpec robot;
  const ModelSpace space{robot,
                         {{"body.torso.mass", "kg", 1.0, 7.0, 1.0, Scale::linear},
                          {"joint.knee.damping", "N*m*s/rad", 1e-3, 1.0, 0.1, Scale::logarithmic}}};
  const ModelEncoding& encoding = built_catalog().get<ModelEncoding>("parameters");
  const GenomeLayout layout = encoding.layout(space, {});
  ASSERT_EQ(layout.size(), 2U);
  EXPECT_EQ(layout.genes[0].name, "body.torso.mass");
  EXPECT_EQ(layout.genes[0].unit, "kg");
  EXPECT_EQ(layout.genes[1].lower, 1e-3);
  EXPECT_EQ(encoding.decode(space, {}, std::array{2.5, 0.25}).values, (std::vector{2.5, 0.25}));
  EXPECT_EQ(encoding.decode(space, {}, std::array{0.5, 2.0}).values, (std::vector{1.0, 1.0}));
}

TEST(ParametersEncoding, WantsFiniteBounds) {
  const RobotSpec robot;
  const ModelSpace space{robot, {{"contact.friction", "1", 0.0, kInfinity, 1.0, Scale::linear}}};
  EXPECT_THAT([&] { built_catalog().get<ModelEncoding>("parameters").layout(space, {}); },
              ThrowsMessage<Error>(HasSubstr("contact.friction")));
}

/// A mass, then an effect that stays, one without free parameters and two with one each that are optional.
class ParametersAndEffectsTest : public testing::Test {
 protected:
  ModelProposal decode(const Genome& genome, double at_most = 0.0) const {
    return encoding_.decode(space_, std::array{at_most}, genome);
  }

  const RobotSpec robot_{};
  ModelSpace space_{robot_,
                    {{"body.torso.mass", "kg", 1.0, 7.0, 1.0, Scale::linear},
                     {"effect.grease.damping", "N*m*s/rad", 0.0, 2.0, 0.0, Scale::linear},
                     {"effect.stick.torque", "N*m", 0.0, 5.0, 0.0, Scale::linear}},
                    {{"stays", false, {}}, {"tilt", true, {}}, {"grease", true, {1}}, {"stick", true, {2}}}};
  const ModelEncoding& encoding_ = built_catalog().get<ModelEncoding>("parameters_and_effects");
};

TEST_F(ParametersAndEffectsTest, HasTheGenesOfParametersAndThenASwitchAnOptionalEffect) {
  const GenomeLayout layout = encoding_.layout(space_, std::array{0.0});
  const GenomeLayout values = built_catalog().get<ModelEncoding>("parameters").layout(space_, {});
  ASSERT_EQ(layout.size(), 6U);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(layout.genes[i].name, values.genes[i].name);
  std::vector<std::string> switches;
  for (std::size_t i = values.size(); i < layout.size(); ++i) {
    switches.push_back(layout.genes[i].name);
    EXPECT_TRUE(layout.genes[i].lower == 0.0 && layout.genes[i].upper == 1.0);
  }
  EXPECT_THAT(switches, testing::ElementsAre("effect.tilt", "effect.grease", "effect.stick"));
}

TEST_F(ParametersAndEffectsTest, WhatIsOffIsLeftOutAndWhatIsOnIsTheStructure) {
  const ModelProposal two = decode({9.0, 0.5, 1.0, 0.2, 0.9, 0.6});
  EXPECT_EQ(two.values, (std::vector{7.0, 0.5, 1.0}));
  EXPECT_THAT(two.without, testing::ElementsAre(1U));
  EXPECT_EQ(two.structure, "grease + stick");
  const ModelProposal none = decode({2.0, 0.5, 1.0, 0.5, 0.0, 0.1});
  EXPECT_THAT(none.without, testing::ElementsAre(1U, 2U, 3U)) << "0.5 is off";
  EXPECT_EQ(none.structure, "no optional effect");
  EXPECT_TRUE(decode({2.0, 0.5, 1.0, 0.51, 1.0, 0.8}).without.empty());
}

TEST_F(ParametersAndEffectsTest, AtMostSoManyHaveTheLargestSwitches) {
  const Genome genome = {2.0, 0.5, 1.0, 0.7, 0.9, 0.8};
  EXPECT_EQ(decode(genome, 1.0).structure, "grease");
  EXPECT_EQ(decode(genome, 2.0).structure, "grease + stick");
  EXPECT_EQ(decode(genome, 3.0).structure, "tilt + grease + stick");
  EXPECT_EQ(decode(genome, 9.0).structure, "tilt + grease + stick");
  EXPECT_EQ(decode({2.0, 0.5, 1.0, 0.8, 0.8, 0.8}, 2.0).structure, "tilt + grease") << "ties by order";
  EXPECT_EQ(decode({2.0, 0.5, 1.0, 0.1, 0.3, 0.4}, 2.0).structure, "no optional effect");
}

TEST_F(ParametersAndEffectsTest, SaysWhatItMisses) {
  EXPECT_THAT([&] { encoding_.layout(space_, std::array{1.5}); }, ThrowsMessage<Error>(HasSubstr("at_most")));
  for (ModelEffect& effect : space_.effects) effect.optional = false;
  EXPECT_THAT([&] { encoding_.layout(space_, std::array{0.0}); },
              ThrowsMessage<Error>(HasSubstr("write optional = true")));
}

TEST_F(ParametersAndEffectsTest, NeedsNoFreeParameter) {
  space_.free.clear();
  space_.effects = {{"tilt", true, {}}};
  EXPECT_EQ(encoding_.layout(space_, std::array{0.0}).size(), 1U);
  EXPECT_EQ(decode({0.8}).structure, "tilt");
}

class RecurrentNetworkTest : public testing::Test {
 protected:
  static TestSpace space(std::size_t sensors, std::size_t actuators) {
    TestSpace space;
    for (std::size_t s = 0; s < sensors; ++s) space.sensors.push_back({"sensor_" + std::to_string(s), "1"});
    for (std::size_t a = 0; a < actuators; ++a) space.actuators.push_back({"motor_" + std::to_string(a), "rad"});
    space.lower.assign(actuators, -1.0);
    space.upper.assign(actuators, 1.0);
    space.control_period = 0.01;
    space.duration = 10.0;
    return space;
  }
  static double activation(double x) { return 2.0 / (1.0 + std::exp(-x)) - 1.0; }
  std::shared_ptr<const Controller> controller(const TestSpace& space, const std::vector<double>& parameters,
                                               const Genome& genome) const {
    return std::get<std::shared_ptr<const Controller>>(encoding_.decode(space, parameters, genome).drive);
  }

  const TestEncoding& encoding_ = built_catalog().get<TestEncoding>("recurrent_network");
};

TEST_F(RecurrentNetworkTest, TheSeedsHasSixtyEightWeights) {
  const GenomeLayout layout = encoding_.layout(space(8, 8), std::array{3.0, 1.0});
  EXPECT_EQ(layout.size(), 68U);
  EXPECT_EQ(encoding_.layout(space(6, 4), std::array{3.0, 1.0}).size(), 46U);  // experiment 2
  for (const Gene& gene : layout.genes) EXPECT_TRUE(gene.lower == -1.0 && gene.upper == 1.0);
}

TEST_F(RecurrentNetworkTest, GenesAreNamedByTheirConnection) {
  std::vector<std::string> names;
  for (const Gene& gene : encoding_.layout(space(1, 1), std::array{2.0, 1.0}).genes) names.push_back(gene.name);
  EXPECT_THAT(names, testing::ElementsAre("sensor_0>hidden1", "hidden1>hidden1", "hidden2>hidden1", "bias>hidden1",
                                          "sensor_0>hidden2", "hidden1>hidden2", "hidden2>hidden2", "bias>hidden2",
                                          "hidden1>motor_0", "hidden2>motor_0", "bias>motor_0"));
}

/// Two periods by hand: hidden from the sensors now and the hidden ones before, commands from the hidden ones now.
TEST_F(RecurrentNetworkTest, FollowsItsEquations) {
  const Genome genome = {0.5, 0.2, -0.3, 0.1, -0.7, 0.9, 0.4, -0.2, 0.6, -0.8, 0.05};
  const auto network = controller(space(1, 1), {2.0, 1.0}, genome);
  ASSERT_EQ(network->state_size(), 2);
  std::array state{0.0, 0.0};
  std::array command{0.0};
  network->act(0.0, std::array{2.0}, state, command);
  const double first1 = activation(0.5 * 2.0 + 0.1), first2 = activation(-0.7 * 2.0 - 0.2);
  EXPECT_NEAR(state[0], first1, kCodeTolerance);
  EXPECT_NEAR(state[1], first2, kCodeTolerance);
  EXPECT_NEAR(command[0], activation(0.6 * first1 - 0.8 * first2 + 0.05), kCodeTolerance);
  network->act(0.01, std::array{-1.0}, state, command);
  const double second1 = activation(-0.5 + 0.2 * first1 - 0.3 * first2 + 0.1);
  const double second2 = activation(0.7 + 0.9 * first1 + 0.4 * first2 - 0.2);
  EXPECT_NEAR(state[0], second1, kCodeTolerance);
  EXPECT_NEAR(state[1], second2, kCodeTolerance);
  EXPECT_NEAR(command[0], activation(0.6 * second1 - 0.8 * second2 + 0.05), kCodeTolerance);
}

TEST_F(RecurrentNetworkTest, CommandsSpanTheActuatorsRange) {
  TestSpace narrow = space(1, 2);
  narrow.lower = {2.0, -4.0};
  narrow.upper = {3.0, -4.0};
  Genome genome(encoding_.layout(narrow, std::array{1.0, 1e3}).size(), 0.0);
  const std::size_t bias = 3 + 1;  // of the first actuator, after the hidden neuron's three weights and its own one
  std::array state{0.0};
  std::array commands{0.0, 0.0};
  for (const auto& [weight, command] : {std::pair{0.0, 2.5}, {1e3, 3.0}, {-1e3, 2.0}}) {
    genome[bias] = weight;
    controller(narrow, {1.0, 1e3}, genome)->act(0.0, std::array{0.0}, state, commands);
    EXPECT_NEAR(commands[0], command, kCodeTolerance);
    EXPECT_EQ(commands[1], -4.0);
  }
}

TEST_F(RecurrentNetworkTest, TheTestLastsAsLongAsTheSpaceSays) {
  const TestSpace robot = space(1, 1);
  EXPECT_EQ(encoding_.decode(robot, std::array{1.0, 1.0}, Genome(5, 0.5)).duration, robot.duration);
}

TEST_F(RecurrentNetworkTest, SaysWhatItCannotDrive) {
  TestSpace endless = space(1, 1);
  endless.upper[0] = kInfinity;
  EXPECT_THAT([&] { encoding_.layout(endless, std::array{3.0, 1.0}); }, ThrowsMessage<Error>(HasSubstr("motor_0")));
  TestSpace named = space(1, 1);
  named.sensors[0].name = "hidden2";
  EXPECT_THAT([&] { encoding_.layout(named, std::array{3.0, 1.0}); }, ThrowsMessage<Error>(HasSubstr("\"hidden2\"")));
  EXPECT_THAT(
      [&] {
        encoding_.layout(space(1, 1), std::array{2.5, 1.0});
      },
      ThrowsMessage<Error>(HasSubstr("whole number")));
}

}  // namespace
}  // namespace lacuna
