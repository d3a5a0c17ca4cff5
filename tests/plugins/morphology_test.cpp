#include "plugins/built_catalog.h"
#include "support/target_genome.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace lacuna {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kPlace = 1e-12;         // m, rounding of a few products of order one
constexpr double kSink = 1e-5;           // m, how deep the target's parts start in the ground
constexpr double kHeight = 0.1 - kSink;  // m, of a part that lies
constexpr std::size_t kRow = 6;

std::vector<double> defaults_of(const ParameterDeclarations& declarations) {
  std::vector<double> values;
  for (const ParameterDeclaration& declaration : declarations) values.push_back(declaration.default_value);
  return values;
}

class MorphologyTest : public testing::Test {
 protected:
  RobotSpec decode(const Genome& genome) const { return *encoding_.decode({target_, {}}, parameters_, genome).robot; }
  double parameter_index(const std::string& name) const {
    const ParameterDeclarations declared = encoding_.parameters();
    for (std::size_t i = 0; i < declared.size(); ++i)
      if (declared[i].name == name) return static_cast<double>(i);
    throw Error("no parameter " + name);
  }
  void set(const std::string& name, double value) {
    parameters_[static_cast<std::size_t>(parameter_index(name))] = value;
  }
  static double& gene(Genome& genome, std::size_t part, std::size_t which) { return genome[part * kRow + which]; }
  RobotSpec five_with(const std::map<std::string, double>& given) const {
    const ParameterDeclarations declared = five_.parameters();
    std::vector<double> parameters = defaults_of(declared);
    for (std::size_t i = 0; i < declared.size(); ++i)
      if (const auto found = given.find(declared[i].name); found != given.end()) parameters[i] = found->second;
    return five_.build({parameters, nullptr});
  }

  const ModelEncoding& encoding_ = built_catalog().get<ModelEncoding>("morphology");
  std::vector<double> parameters_ = defaults_of(encoding_.parameters());
  const RobotDefinition& five_ = built_catalog().get<RobotDefinition>("five_cylinders");
  RobotSpec target_ = five_.build({defaults_of(five_.parameters()), nullptr});
};

TEST_F(MorphologyTest, TheTargetsGenomeIsTheTarget) {
  const RobotSpec model = decode(five_cylinders_genome());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT((model.bodies[i].position - target_.bodies[i].position).norm(), kPlace) << target_.bodies[i].name;
    EXPECT_NEAR(model.bodies[i].shapes[0].size.y(), target_.bodies[i].shapes[0].size.y(), kPlace);
    EXPECT_NEAR(model.bodies[i].inertia.yy, target_.bodies[i].inertia.yy, kPlace);
    EXPECT_NEAR(model.bodies[i].inertia.xx, target_.bodies[i].inertia.xx, kPlace);
  }
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_EQ(model.joints[j].parent, target_.joints[j].parent);
    EXPECT_LT((model.joints[j].anchor - target_.joints[j].anchor).norm(), kPlace);
    EXPECT_LT((model.joints[j].axis - target_.joints[j].axis).norm(), kPlace) << target_.joints[j].name;
  }
  for (std::size_t s = 0; s < target_.sensors.size(); ++s) {
    EXPECT_EQ(model.sensors[s].element, target_.sensors[s].element);
    EXPECT_EQ(model.sensors[s].scale, target_.sensors[s].scale);
  }
}

/// A row a part, and a crossover cuts between them.
TEST_F(MorphologyTest, HasSixGenesAPart) {
  const GenomeLayout layout = encoding_.layout({target_, {}}, parameters_);
  ASSERT_EQ(layout.size(), 30U);
  EXPECT_EQ(layout.row, 6U);
  EXPECT_EQ(layout.genes[6 + 2].name, "front.length");
  EXPECT_EQ(layout.genes[6 + 2].unit, "m");
  EXPECT_EQ(layout.genes[6 + 2].lower, 0.1);
  EXPECT_EQ(layout.genes[6 + 2].upper, 2.0);
}

/// The first part is known to lie, wherever the experiment's robot has it.
TEST_F(MorphologyTest, TheFirstPartIsAsHighAsTheRobots) {
  target_ = five_with({{"radius", 0.3}, {"sink", 0.02}});
  EXPECT_NEAR(decode(five_cylinders_genome()).bodies[0].position.z(), 0.28, kPlace);
}

TEST_F(MorphologyTest, AParentIsAnyPartBefore) {
  Genome genome = five_cylinders_genome();
  const std::array<const char*, 3> expected = {"torso", "front", "rear"};
  for (std::size_t parent = 0; parent < 3; ++parent) {
    gene(genome, 3, 0) = (static_cast<double>(parent) + 0.5) / 3.0;
    EXPECT_EQ(decode(genome).joints[2].parent, expected[parent]);
  }
  gene(genome, 3, 0) = 1.0;
  EXPECT_EQ(decode(genome).joints[2].parent, "rear") << "the upper bound is the last of them";
}

/// Two quarter turns about the parts' own axes: the second part left, the third up from there.
TEST_F(MorphologyTest, AnglesAddUpAlongTheChain) {
  Genome genome = five_cylinders_genome();
  gene(genome, 1, 4) = 0.5;                            // front: to the left
  gene(genome, 2, 0) = 1.0, gene(genome, 2, 1) = 1.0;  // rear: on the front part's head
  gene(genome, 2, 3) = 0.5, gene(genome, 2, 4) = 0.5;  // rolled by π/2, so that its left is up
  const RobotSpec model = decode(genome);
  EXPECT_LT((model.bodies[1].position - Vector3d(0.5, 0.5, kHeight)).norm(), kPlace);
  EXPECT_LT((model.bodies[2].position - Vector3d(0.5, 1.0, kHeight + 0.5)).norm(), kPlace);
  EXPECT_EQ(model.joints[1].axis, Vector3d::UnitY()) << "a part that points up swings fore and aft";
  set("vertical_axis", 0.0);
  EXPECT_EQ(decode(genome).joints[1].axis, Vector3d::UnitX());
}

TEST_F(MorphologyTest, TheFirstTwoTouchSensorsCountAndMissingOnesReadNothing) {
  Genome genome = five_cylinders_genome();
  for (std::size_t part = 0; part < 5; ++part) gene(genome, part, 5) = 1.0;
  RobotSpec model = decode(genome);
  EXPECT_EQ(model.sensors[0].element, "torso");
  EXPECT_EQ(model.sensors[1].element, "front");
  EXPECT_EQ(model.sensors[1].scale, 1.0);
  for (std::size_t part = 0; part < 5; ++part) gene(genome, part, 5) = part == 3 ? 1.0 : 0.0;
  model = decode(genome);
  EXPECT_EQ(model.sensors[0].element, "left_arm");
  EXPECT_EQ(model.sensors[1].scale, 0.0);
  gene(genome, 1, 2) = 1.8;
  EXPECT_EQ(decode(genome).sensors[1].element, model.sensors[1].element) << "a length moves no sensor";
}

TEST_F(MorphologyTest, WhatIsBelowTheGroundStaysOrIsLifted) {
  Genome genome = five_cylinders_genome();
  gene(genome, 1, 3) = 0.5, gene(genome, 1, 4) = 0.5;                            // front: up, from the torso's head
  gene(genome, 3, 0) = 0.4, gene(genome, 3, 1) = 0.0;                            // left arm: on the front part's tail
  gene(genome, 3, 3) = 0.0, gene(genome, 3, 4) = 1.0, gene(genome, 3, 2) = 1.0;  // and turned by π: down
  EXPECT_LT((decode(genome).bodies[3].position - Vector3d(0.5, 0.0, kHeight - 0.5)).norm(), kPlace);
  set("lift", 1.0);
  const RobotSpec lifted = decode(genome);
  EXPECT_LT((lifted.bodies[3].position - Vector3d(0.5, 0.0, 0.5 - kSink)).norm(), kPlace) << "its end is on the ground";
  EXPECT_LT((lifted.bodies[0].position - Vector3d(0.0, 0.0, 1.0 - kSink)).norm(), kPlace);
  EXPECT_LT((lifted.joints[2].anchor - Vector3d(0.5, 0.0, 1.0 - kSink)).norm(), kPlace);
  EXPECT_NEAR(decode(five_cylinders_genome()).bodies[3].position.z(), kHeight, kPlace) << "the target is where it was";
}

TEST_F(MorphologyTest, WantsCylindersOnHinges) {
  RobotSpec robot = target_;
  robot.joints[1].kind = JointKind::slider;
  EXPECT_THAT([&] { encoding_.layout({robot, {}}, parameters_); }, ThrowsMessage<Error>(HasSubstr("\"rear\"")));
  robot = target_;
  robot.bodies[2].shapes[0].kind = ShapeKind::box;
  EXPECT_THAT([&] { encoding_.layout({robot, {}}, parameters_); }, ThrowsMessage<Error>(HasSubstr("cylinder")));
  set("l_min", 3.0);
  EXPECT_THAT([&] { encoding_.layout({target_, {}}, parameters_); }, ThrowsMessage<Error>(HasSubstr("l_min")));
}

/// A scale that a dead sensor would get back.
TEST_F(MorphologyTest, TheScaleOfATouchSensorIsNotFree) {
  const auto layout_with = [&](const std::string& address) {
    return encoding_.layout({target_, {{address, "1", 0.0, 2.0, 1.0, Scale::linear}}}, parameters_);
  };
  EXPECT_EQ(layout_with("sensor.angle_front.scale").size(), 31U);
  EXPECT_THAT([&] { layout_with("sensor.touch_2.scale"); }, ThrowsMessage<Error>(HasSubstr("sensor.touch_2.scale")));
}

class PartDistanceTest : public MorphologyTest {
 protected:
  double score(const RobotSpec& model, const std::string& name) const {
    ModelProposal proposal;
    proposal.robot = std::make_shared<RobotSpec>(model);
    for (const ObjectiveScore& score : metric_.score({target_, {}}, proposal, {{}, target_}, {}))
      if (score.name == name) return score.value;
    return NAN;
  }
  double topology_wrong(const Genome& genome) const { return score(decode(genome), "topology_wrong"); }

  const ObjectiveMetric& metric_ = built_catalog().get<ObjectiveMetric>("part_distance");
};

TEST_F(PartDistanceTest, IsTheMeanOverTheParts) {
  RobotSpec model = target_;
  model.bodies[3].position += Vector3d(0.3, 0.0, 0.4);
  EXPECT_NEAR(score(model, "body.left_arm.position"), 0.5, kPlace);
  EXPECT_NEAR(score(model, "body.*.position"), 0.1, kPlace);
  EXPECT_EQ(score(target_, "body.*.position"), 0.0);
}

TEST_F(PartDistanceTest, TheTopologyIsWhichEndsMeet) {
  Genome genome = five_cylinders_genome();
  EXPECT_EQ(topology_wrong(genome), 0.0);
  gene(genome, 4, 2) = 0.3, gene(genome, 4, 4) = 0.3;
  EXPECT_EQ(topology_wrong(genome), 0.0) << "lengths and angles are not topology";
  gene(genome, 3, 0) = 0.4, gene(genome, 3, 1) = 0.0;
  EXPECT_EQ(decode(genome).joints[2].parent, "front");
  EXPECT_EQ(topology_wrong(genome), 0.0) << "a sibling's tail is the parent's head";
  gene(genome, 3, 1) = 1.0;
  EXPECT_EQ(topology_wrong(genome), 1.0) << "a sibling's head is not";
  genome = five_cylinders_genome();
  gene(genome, 2, 1) = 1.0;
  EXPECT_EQ(topology_wrong(genome), 1.0);
}

/// As the figure topology_wrong has it.
TEST_F(PartDistanceTest, AStructureIsWhichEndsMeet) {
  const auto structure = [&](const Genome& genome) {
    return encoding_.decode({target_, {}}, parameters_, genome).structure;
  };
  Genome genome = five_cylinders_genome();
  EXPECT_EQ(structure(genome), "0h 0t 0h 0h");
  gene(genome, 4, 2) = 0.3, gene(genome, 4, 4) = 0.3;
  gene(genome, 3, 0) = 0.4, gene(genome, 3, 1) = 0.0;
  EXPECT_EQ(structure(genome), "0h 0t 0h 0h") << "a sibling's tail is the parent's head";
  gene(genome, 3, 1) = 1.0;
  EXPECT_EQ(structure(genome), "0h 0t 1h 0h");
  gene(genome, 2, 1) = 1.0;
  EXPECT_EQ(structure(genome), "0h 0h 1h 0h");
}

TEST_F(PartDistanceTest, AnArmOnTheMiddleOfAPartIsOnNoEnd) {
  const RobotSpec literal = five_with({{"arms_in_middle", 1.0}});
  EXPECT_LT((literal.bodies[3].position - Vector3d(1.0, 0.4, kHeight)).norm(), kPlace);
  EXPECT_EQ(score(literal, "topology_wrong"), 1.0);
  EXPECT_NEAR(score(literal, "body.*.position"), 2.0 * 0.5 / 5.0, kPlace);
}

TEST_F(PartDistanceTest, RobotsOfOtherNumbersOfPartsAreRefused) {
  RobotSpec model = target_;
  model.bodies.pop_back();
  EXPECT_THROW(score(model, "topology_wrong"), Error);
}

class ReshapeTest : public MorphologyTest {
 protected:
  enum What { kHangElsewhere, kStretchFirst, kMove, kLineUp };

  /// A child to which nothing else was done.
  Genome reshaped(const Genome& genome, What what, std::uint64_t key) const {
    std::vector<double> parameters = defaults_of(reshape_.parameters());
    parameters[0] = what == kHangElsewhere ? 1.0 : 0.0;
    parameters[1] = what == kStretchFirst ? 1.0 : 0.0;
    parameters[2] = what == kLineUp ? 1.0 : 0.0;
    RandomStream random(std::vector<std::uint64_t>{key});
    return reshape_.vary(std::array{genome}, encoding_.layout({target_, {}}, parameters_), parameters, random);
  }
  int moved(const Genome& before, const Genome& after) const {
    const RobotSpec a = decode(before), b = decode(after);
    int parts = 0;
    for (std::size_t i = 0; i < 5; ++i) parts += (a.bodies[i].position - b.bodies[i].position).norm() > 1e-9 ? 1 : 0;
    return parts;
  }
  /// The target with its parts off the bounds of roll and turn.
  static Genome raised() {
    Genome genome = five_cylinders_genome();
    for (std::size_t part = 1; part < 5; ++part) gene(genome, part, 3) = 0.4, gene(genome, part, 4) = 0.3;
    return genome;
  }

  const MutationOperator& reshape_ = built_catalog().get<MutationOperator>("reshape");
};

/// A part can hang elsewhere without moving wherever its length and the half of directions that it has allow it.
TEST_F(ReshapeTest, HangsAPartElsewhereAndLeavesTheCentres) {
  int other_trees = 0, unmoved = 0;
  for (std::uint64_t key = 0; key < 200; ++key) {
    const Genome child = reshaped(five_cylinders_genome(), kHangElsewhere, key);
    const RobotSpec robot = decode(child);
    bool other = false;
    for (std::size_t j = 0; j < 4; ++j)
      other = other || robot.joints[j].parent != target_.joints[j].parent ||
              (robot.joints[j].anchor - target_.joints[j].anchor).norm() > kPlace;
    other_trees += other ? 1 : 0;
    unmoved += moved(five_cylinders_genome(), child) == 0 ? 1 : 0;
  }
  EXPECT_EQ(other_trees, 200);
  EXPECT_GT(unmoved, 10) << "the arms reach the tail of the front part, for one";
}

TEST_F(ReshapeTest, MovesOnePartAndLeavesTheOthers) {
  int one = 0;
  for (std::uint64_t key = 0; key < 200; ++key) one += moved(raised(), reshaped(raised(), kMove, key)) == 1 ? 1 : 0;
  EXPECT_GT(one, 150) << "the others are long moves that a length or a direction stops";
}

TEST_F(ReshapeTest, StretchesTheFirstPartUnderTheOthers) {
  int other_length = 0, unmoved = 0;
  for (std::uint64_t key = 0; key < 200; ++key) {
    const Genome child = reshaped(raised(), kStretchFirst, key);
    other_length += child[2] != raised()[2] ? 1 : 0;
    unmoved += moved(raised(), child) == 0 ? 1 : 0;
  }
  EXPECT_EQ(other_length, 200);
  EXPECT_GT(unmoved, 150);
}

TEST_F(ReshapeTest, LinesPartsUp) {
  Genome genome = five_cylinders_genome();
  gene(genome, 1, 3) = 0.5, gene(genome, 1, 4) = 0.1;  // front: a little upwards
  int flat = 0;
  for (std::uint64_t key = 0; key < 400; ++key)
    flat += std::abs(decode(reshaped(genome, kLineUp, key)).bodies[1].position.z() - kHeight) < kPlace ? 1 : 0;
  // One of four parts, one of three axes, and any other part's height: 33 on average.
  EXPECT_NEAR(flat, 33.3, 5.0 * std::sqrt(33.3));
}

/// Where a part cannot reach its old place, no length and no direction would have come nearer.
TEST_F(ReshapeTest, TakesTheNearestPlaceThereIs) {
  const RobotSpec before = decode(five_cylinders_genome());
  for (std::uint64_t key = 0; key < 100; ++key) {
    const Genome child = reshaped(five_cylinders_genome(), kHangElsewhere, key);
    const RobotSpec robot = decode(child);
    RandomStream random(std::vector<std::uint64_t>{key});
    for (std::size_t part = 1; part < 5; ++part) {
      const double distance = (robot.bodies[part].position - before.bodies[part].position).norm();
      for (int i = 0; i < 50; ++i) {
        Genome other = child;
        if (i % 2 == 1) gene(other, part, 2) = random.uniform(0.1, 2.0);
        for (const std::size_t angle : {3U, 4U})
          gene(other, part, angle) = std::clamp(gene(other, part, angle) + random.uniform(-0.1, 0.1), 0.0, 1.0);
        ASSERT_GE((decode(other).bodies[part].position - before.bodies[part].position).norm(), distance - kPlace);
      }
    }
  }
}

/// The genes' bounds are what the encoding was told, and nothing need be said twice.
TEST_F(ReshapeTest, LengthsKeepToTheLayout) {
  set("l_min", 0.5), set("l_max", 1.2);
  bool shortest = false, longest = false;
  for (std::uint64_t key = 0; key < 400; ++key) {
    const Genome child = reshaped(raised(), key % 2 == 0 ? kStretchFirst : kMove, key);
    for (std::size_t part = 0; part < 5; ++part) {
      ASSERT_GE(child[part * kRow + 2], 0.5);
      ASSERT_LE(child[part * kRow + 2], 1.2);
      shortest = shortest || child[part * kRow + 2] == 0.5;
      longest = longest || child[part * kRow + 2] == 1.2;
    }
  }
  EXPECT_TRUE(shortest && longest);
}

TEST_F(ReshapeTest, WantsRowsOfSixGenes) {
  GenomeLayout layout = encoding_.layout({target_, {}}, parameters_);
  layout.row = 0;
  RandomStream random(std::vector<std::uint64_t>{1});
  EXPECT_THAT(
      [&] { reshape_.vary(std::array{five_cylinders_genome()}, layout, defaults_of(reshape_.parameters()), random); },
      ThrowsMessage<Error>(HasSubstr("six genes")));
}

}  // namespace
}  // namespace lacuna
