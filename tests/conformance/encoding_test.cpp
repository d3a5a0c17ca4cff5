#include "conformance/every_plugin.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

/// What holds for every encoding of models and of tests.
namespace lacuna {
namespace {

constexpr int kGenomes = 200;
constexpr double kNanOfEncoding = std::numeric_limits<double>::quiet_NaN();

class EncodingConformance : public testing::Test {
 protected:
  EncodingConformance() {
    for (const char* name : {"torso", "leg", "arm"}) add_part(name);
    models_.free = {{"body.torso.mass", "kg", 1.0, 7.0, 2.0, Scale::linear},
                    {"joint.knee.damping", "N*m*s/rad", 1e-4, 10.0, 0.1, Scale::logarithmic},
                    {"sensor.t1.delay", "s", 0.0, 0.2, 0.0, Scale::linear},
                    {"effect.grease.damping", "N*m*s/rad", 0.0, 2.0, 0.5, Scale::linear}};
    models_.effects = {{"stays", false, {}}, {"grease", true, {3}}, {"tilt", true, {}}};
    tests_.sensors = {{"touch", "1"}, {"angle", "rad"}, {"speed", "rad/s"}};
    tests_.actuators = {{"hip", "rad"}, {"knee", "rad"}};
    tests_.lower = {-1.0, 0.25};
    tests_.upper = {1.0, 0.75};
    tests_.control_period = 0.01;
    tests_.duration = 0.5;
  }

  /// A cylinder, on a hinge on the first one.
  void add_part(const std::string& name) {
    BodySpec body;
    body.name = name;
    body.shapes = {{.kind = ShapeKind::cylinder, .size = {0.1, 1.0, 0.0}}};
    robot_.bodies.push_back(body);
    if (robot_.bodies.size() == 1) return;
    JointSpec joint;
    joint.name = name;
    joint.parent = robot_.bodies.front().name;
    joint.child = name;
    robot_.joints.push_back(joint);
  }

  RobotSpec robot_;
  ModelSpace models_{robot_, {}};
  TestSpace tests_;
};

void check_layout(const GenomeLayout& layout) {
  ASSERT_GT(layout.size(), 0U);
  std::set<std::string> names;
  for (const Gene& gene : layout.genes) {
    EXPECT_FALSE(gene.name.empty());
    EXPECT_FALSE(gene.unit.empty()) << gene.name;
    EXPECT_TRUE(names.insert(gene.name).second) << gene.name << " stands twice";
    EXPECT_TRUE(std::isfinite(gene.lower) && std::isfinite(gene.upper)) << gene.name;
    EXPECT_LE(gene.lower, gene.upper) << gene.name;
    const bool whole = gene.lower == std::floor(gene.lower) && gene.upper == std::floor(gene.upper);
    EXPECT_TRUE(gene.kind == GeneKind::real || whole) << gene.name;
  }
  EXPECT_EQ(layout.size() % std::max<std::size_t>(layout.row, 1), 0U) << "rows of " << layout.row;
}

/// Random genomes fit, the same stream gives the same one, another stream another.
template <class Encoding>
void check_random_genomes(const Encoding& encoding, const GenomeLayout& layout) {
  for (std::uint64_t key = 0; key < kGenomes; ++key) {
    RandomStream one = stream_of(key), same = stream_of(key), other = stream_of(key + kGenomes);
    const Genome genome = encoding.random(layout, one);
    EXPECT_TRUE(fits(layout, genome));
    EXPECT_EQ(genome, encoding.random(layout, same));
    EXPECT_NE(genome, encoding.random(layout, other));
  }
}

/// Commands that a test gives, period after period, for sensors that read a little of everything.
std::vector<double> commands_of(const Test& test, const TestSpace& space) {
  if (const auto* series = std::get_if<CommandSeries>(&test.drive)) {
    const TimeSeries::Samples& samples = series->series.samples;
    return {samples.data(), samples.data() + samples.size()};
  }
  const Controller& controller = *std::get<std::shared_ptr<const Controller>>(test.drive);
  std::vector<double> state(static_cast<std::size_t>(controller.state_size()), 0.0), all;
  std::vector<double> sensors(space.sensors.size());
  std::vector<double> commands(space.actuators.size(), kNanOfEncoding);
  for (int period = 0; period * space.control_period < test.duration; ++period) {
    const double time = period * space.control_period;
    for (std::size_t s = 0; s < sensors.size(); ++s) sensors[s] = 3.0 * std::sin(20.0 * time + static_cast<double>(s));
    controller.act(time, sensors, state, commands);
    all.insert(all.end(), commands.begin(), commands.end());
  }
  return all;
}

TEST_F(EncodingConformance, LayoutsOfModelsAreSound) {
  on_every<ModelEncoding>([&](const ModelEncoding& encoding, const std::vector<double>& parameters) {
    const GenomeLayout layout = encoding.layout(models_, parameters);
    check_layout(layout);
    check_random_genomes(encoding, layout);
  });
}

TEST_F(EncodingConformance, LayoutsOfTestsAreSound) {
  on_every<TestEncoding>([&](const TestEncoding& encoding, const std::vector<double>& parameters) {
    const GenomeLayout layout = encoding.layout(tests_, parameters);
    check_layout(layout);
    check_random_genomes(encoding, layout);
  });
}

std::vector<std::string> parents_of(const RobotSpec& robot) {
  std::vector<std::string> parents;
  for (const JointSpec& joint : robot.joints) parents.push_back(joint.parent);
  return parents;
}

/// A robot of an encoding has the elements of the experiment's, and the same genome gives the same one.
void check_robot(const ModelProposal& model, const ModelProposal& again, const RobotSpec& of_experiment) {
  ASSERT_EQ(model.robot == nullptr, again.robot == nullptr);
  if (!model.robot) return;
  ASSERT_EQ(model.robot->bodies.size(), of_experiment.bodies.size());
  for (std::size_t i = 0; i < of_experiment.bodies.size(); ++i) {
    EXPECT_EQ(model.robot->bodies[i].name, of_experiment.bodies[i].name);
    EXPECT_EQ(model.robot->bodies[i].position, again.robot->bodies[i].position);
    EXPECT_TRUE(model.robot->bodies[i].position.allFinite());
  }
  ASSERT_EQ(model.robot->joints.size(), of_experiment.joints.size());
  for (std::size_t i = 0; i < of_experiment.joints.size(); ++i)
    EXPECT_EQ(model.robot->joints[i].name, of_experiment.joints[i].name);
  EXPECT_EQ(parents_of(*model.robot), parents_of(*again.robot));
}

/// Left-out effects are optional ones, in order; the structure is the genome's alone.
void check_effects(const ModelProposal& model, const ModelProposal& again, const ModelSpace& space) {
  EXPECT_EQ(model.structure, again.structure);
  EXPECT_EQ(model.without, again.without);
  EXPECT_TRUE(std::is_sorted(model.without.begin(), model.without.end()));
  EXPECT_EQ(std::adjacent_find(model.without.begin(), model.without.end()), model.without.end());
  for (const std::size_t effect : model.without) {
    ASSERT_LT(effect, space.effects.size());
    EXPECT_TRUE(space.effects[effect].optional) << space.effects[effect].id;
  }
}

TEST_F(EncodingConformance, AGenomeIsOneModelWithinItsBounds) {
  on_every<ModelEncoding>([&](const ModelEncoding& encoding, const std::vector<double>& parameters) {
    const GenomeLayout layout = encoding.layout(models_, parameters);
    for (std::uint64_t key = 0; key < kGenomes; ++key) {
      RandomStream random = stream_of(key);
      const Genome genome = encoding.random(layout, random);
      const ModelProposal model = encoding.decode(models_, parameters, genome);
      const ModelProposal again = encoding.decode(models_, parameters, genome);
      EXPECT_EQ(model.values, again.values);
      check_robot(model, again, robot_);
      check_effects(model, again, models_);
      ASSERT_EQ(model.values.size(), models_.free.size());
      for (std::size_t i = 0; i < model.values.size(); ++i) {
        EXPECT_GE(model.values[i], models_.free[i].lower) << models_.free[i].address;
        EXPECT_LE(model.values[i], models_.free[i].upper) << models_.free[i].address;
      }
    }
  });
}

TEST_F(EncodingConformance, AGenomeIsOneTestWithinItsBounds) {
  on_every<TestEncoding>([&](const TestEncoding& encoding, const std::vector<double>& parameters) {
    const GenomeLayout layout = encoding.layout(tests_, parameters);
    for (std::uint64_t key = 0; key < kGenomes; ++key) {
      RandomStream random = stream_of(key);
      const Genome genome = encoding.random(layout, random);
      const lacuna::Test test = encoding.decode(tests_, parameters, genome);
      EXPECT_GT(test.duration, 0.0);
      EXPECT_LE(test.duration, tests_.duration);
      const std::vector<double> commands = commands_of(test, tests_);
      EXPECT_EQ(commands, commands_of(encoding.decode(tests_, parameters, genome), tests_));
      EXPECT_EQ(commands, commands_of(test, tests_)) << "a test that was carried out is another one";
      for (std::size_t i = 0; i < commands.size(); ++i) {
        EXPECT_GE(commands[i], tests_.lower[i % tests_.lower.size()]);
        EXPECT_LE(commands[i], tests_.upper[i % tests_.upper.size()]);
      }
    }
  });
}

TEST_F(EncodingConformance, GenomesOfAnotherLengthAreRefused) {
  on_every<ModelEncoding>([&](const ModelEncoding& encoding, const std::vector<double>& parameters) {
    const Genome long_one(encoding.layout(models_, parameters).size() + 1, 1.0);
    EXPECT_THROW(encoding.decode(models_, parameters, long_one), Error);
  });
  on_every<TestEncoding>([&](const TestEncoding& encoding, const std::vector<double>& parameters) {
    const Genome long_one(encoding.layout(tests_, parameters).size() + 1, 0.5);
    EXPECT_THROW(encoding.decode(tests_, parameters, long_one), Error);
  });
}

TEST_F(EncodingConformance, WhereThereIsNothingToEncodeASentenceSaysSo) {
  models_.free.clear();
  models_.effects.clear();
  robot_ = {};
  on_every<ModelEncoding>([&](const ModelEncoding& encoding, const std::vector<double>& parameters) {
    EXPECT_THROW(encoding.layout(models_, parameters), Error);
  });
  tests_.actuators.clear();
  tests_.lower.clear();
  tests_.upper.clear();
  on_every<TestEncoding>([&](const TestEncoding& encoding, const std::vector<double>& parameters) {
    EXPECT_THROW(encoding.layout(tests_, parameters), Error);
  });
}

}  // namespace
}  // namespace lacuna
