#include "loading/effect_trial.h"
#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/genome_inputs.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna {
namespace {

constexpr std::uint64_t kGenomes = 30;

/// The first fault of a layout; empty: none.
std::string layout_fault(const GenomeLayout& layout) {
  if (layout.size() == 0) return "layout() has no gene; throw an Error if there is nothing to encode";
  std::set<std::string> names;
  for (const Gene& gene : layout.genes) {
    if (gene.name.empty() || gene.unit.empty()) return "a gene has no name or no unit; name both, \"1\" is a unit";
    if (!names.insert(gene.name).second) return "two genes are called " + gene.name + "; rename one";
    if (!std::isfinite(gene.lower) || !std::isfinite(gene.upper) || gene.lower > gene.upper)
      return "the gene " + gene.name + " has no finite range, lower to upper";
    if (gene.kind == GeneKind::integer &&
        (gene.lower != std::floor(gene.lower) || gene.upper != std::floor(gene.upper)))
      return "the gene " + gene.name + " is a whole number, but its bounds are not";
  }
  if (layout.row > 0 && layout.size() % layout.row != 0) return "the genes do not fill rows of layout.row";
  return {};
}

/// The common part of encodings of models and of tests.
template <class Encoding, class Space>
class EncodingExercise : public Exercise {
 public:
  explicit EncodingExercise(const Encoding& encoding) : encoding_(encoding) {}

  ParameterDeclarations declared() const override { return encoding_.parameters(); }

  void go(const Setting& setting, Transcript& transcript) const override {
    const GenomeLayout layout = encoding_.layout(space(), setting);
    for (const Gene& gene : layout.genes) {
      transcript.add_text("layout", gene.name + " " + gene.unit);
      transcript.add("layout", gene.lower);
      transcript.add("layout", gene.upper);
    }
    for (std::uint64_t key = 0; key < kGenomes; ++key) {
      const Genome genome = random_genome(layout, key);
      transcript.add("random", genome);
      write_down(setting, genome, transcript);
    }
  }

  std::vector<std::string> broken_promises() const override {
    const Setting setting = settings().front();
    const GenomeLayout layout = encoding_.layout(space(), setting);
    std::vector<std::string> broken;
    if (const std::string fault = layout_fault(layout); !fault.empty()) return {fault};
    bool all_alike = true;
    for (std::uint64_t key = 0; key < kGenomes && broken.empty(); ++key) {
      const Genome genome = random_genome(layout, key);
      all_alike = all_alike && genome == random_genome(layout, key + kGenomes);
      if (const std::string fault = genome_fault(layout, genome); !fault.empty())
        broken.push_back("a random genome does not match the layout: " + fault);
      else if (const std::string bad = decoded_fault(setting, genome); !bad.empty())
        broken.push_back(bad);
    }
    if (all_alike) broken.emplace_back("random() returns the same genome for every stream; draw from the stream");
    if (takes_other_length(setting, layout.size()))
      broken.emplace_back("decode() accepts a genome of another length than the layout's; throw an Error");
    return broken;
  }

 protected:
  virtual const Space& space() const = 0;
  virtual void write_down(const Setting& setting, const Genome& genome, Transcript& transcript) const = 0;
  /// The fault of a decoded genome; empty: it is valid.
  virtual std::string decoded_fault(const Setting& setting, const Genome& genome) const = 0;

  Genome random_genome(const GenomeLayout& layout, std::uint64_t key) const {
    RandomStream random = stream_of(key);
    return encoding_.random(layout, random);
  }
  Genome any_genome(const Setting& setting) const { return random_genome(encoding_.layout(space(), setting), 1); }

  const Encoding& encoding_;

 private:
  bool takes_other_length(const Setting& setting, std::size_t size) const {
    try {
      encoding_.decode(space(), setting, Genome(size + 1, 0.5));
      return true;
    } catch (const Error&) {
      return false;
    }
  }
};

/// A robot of three cylinders, two of them attached to the first.
RobotSpec three_cylinders() {
  RobotSpec robot;
  for (const char* name : {"torso", "leg", "arm"}) {
    BodySpec& body = robot.bodies.emplace_back();
    body.name = name;
    body.shapes = {{.kind = ShapeKind::cylinder, .size = {0.1, 1.0, 0.0}}};
    if (robot.bodies.size() == 1) continue;
    JointSpec& joint = robot.joints.emplace_back();
    joint.name = joint.child = name;
    joint.parent = "torso";
  }
  return robot;
}

class ModelEncodingExercise : public EncodingExercise<ModelEncoding, ModelSpace> {
 public:
  explicit ModelEncodingExercise(const ModelEncoding& encoding) : EncodingExercise(encoding) {
    space_.free = {{"body.torso.mass", "kg", 1.0, 7.0, 2.0, Scale::linear},
                   {"joint.leg.damping", "N*m*s/rad", 1e-4, 10.0, 0.1, Scale::logarithmic},
                   {"sensor.t1.delay", "s", 0.0, 0.2, 0.0, Scale::linear},
                   {"effect.grease.damping", "N*m*s/rad", 0.0, 2.0, 0.5, Scale::linear}};
    space_.effects = {{"stays", false, {}}, {"grease", true, {3}}, {"tilt", true, {}}};
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    const Genome genome = any_genome(setting);
    return {repeated_call("decode", true, 50, [&] { encoding_.decode(space_, setting, genome); })};
  }

 protected:
  const ModelSpace& space() const override { return space_; }
  void write_down(const Setting& setting, const Genome& genome, Transcript& transcript) const override {
    const ModelProposal model = encoding_.decode(space_, setting, genome);
    transcript.add("decode", model.values);
    transcript.add_text("decode", model.structure);
    for (const std::size_t effect : model.without) transcript.add("decode", static_cast<double>(effect));
    if (!model.robot) return;
    transcript.add("decode", numbers_of(*model.robot), Transcript::May::be_infinite);
    for (const BodySpec& body : model.robot->bodies) transcript.add("decode", std::span(body.position.data(), 3));
    for (const JointSpec& joint : model.robot->joints) transcript.add_text("decode", joint.parent);
  }
  std::string decoded_fault(const Setting& setting, const Genome& genome) const override {
    const ModelProposal model = encoding_.decode(space_, setting, genome);
    if (model.values.size() != space_.free.size())
      return fmt::format("decode() returns {} values for {} free parameters", model.values.size(), space_.free.size());
    for (std::size_t i = 0; i < model.values.size(); ++i)
      if (!(model.values[i] >= space_.free[i].lower && model.values[i] <= space_.free[i].upper))
        return space_.free[i].address + " leaves its search range; clamp it";
    for (const std::size_t effect : model.without)
      if (effect >= space_.effects.size() || !space_.effects[effect].optional)
        return "decode() leaves out an effect that is not optional";
    if (!std::is_sorted(model.without.begin(), model.without.end()))
      return "`without` is not ascending; sort the indices of the effects";
    if (model.robot &&
        (model.robot->bodies.size() != robot_.bodies.size() || model.robot->joints.size() != robot_.joints.size()))
      return "the robot of a model has other elements than the experiment's; keep them, by name and in order";
    return {};
  }

 private:
  const RobotSpec robot_ = three_cylinders();
  ModelSpace space_{robot_, {}};
};

constexpr double kReadingRate = 20.0;  // rad/s

class TestEncodingExercise : public EncodingExercise<TestEncoding, TestSpace> {
 public:
  explicit TestEncodingExercise(const TestEncoding& encoding) : EncodingExercise(encoding) {
    space_.sensors = {{"touch", "1"}, {"angle", "rad"}, {"speed", "rad/s"}};
    space_.actuators = {{"hip", "rad"}, {"knee", "rad"}};
    space_.lower = {-1.0, 0.25};
    space_.upper = {1.0, 0.75};
    space_.control_period = 0.01;
    space_.duration = 0.5;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    const Genome genome = any_genome(setting);
    std::vector<RepeatedCall> calls = {
        repeated_call("decode", true, 20, [&] { encoding_.decode(space_, setting, genome); })};
    const Test test = encoding_.decode(space_, setting, genome);
    const auto* controller = std::get_if<std::shared_ptr<const Controller>>(&test.drive);
    if (controller == nullptr) return calls;
    std::vector<double> state(static_cast<std::size_t>((*controller)->state_size()), 0.0);
    const std::vector<double> sensors(space_.sensors.size(), 0.3);
    std::vector<double> commands(space_.actuators.size());
    calls.push_back(repeated_call("act, of its controller", false, 100,
                                  [&] { (*controller)->act(0.1, sensors, state, commands); }));
    return calls;
  }

 protected:
  const TestSpace& space() const override { return space_; }
  void write_down(const Setting& setting, const Genome& genome, Transcript& transcript) const override {
    const Test test = encoding_.decode(space_, setting, genome);
    transcript.add("decode", test.duration);
    transcript.add("decode", commands_of(test));
  }
  std::string decoded_fault(const Setting& setting, const Genome& genome) const override {
    const Test test = encoding_.decode(space_, setting, genome);
    if (!(test.duration > 0.0 && test.duration <= space_.duration))
      return fmt::format("a test lasts {} s; at most {} s are allowed, the space's duration", test.duration,
                         space_.duration);
    const std::vector<double> commands = commands_of(test);
    for (std::size_t i = 0; i < commands.size(); ++i)
      if (!(commands[i] >= space_.lower[i % 2] && commands[i] <= space_.upper[i % 2]))
        return fmt::format("a command of {} is {}, which is beyond its range of {} to {}; clamp it",
                           space_.actuators[i % 2].name, commands[i], space_.lower[i % 2], space_.upper[i % 2]);
    return {};
  }

 private:
  /// Commands that a test gives, period after period, for sensors that read a little of everything.
  std::vector<double> commands_of(const Test& test) const {
    if (const auto* series = std::get_if<CommandSeries>(&test.drive)) {
      const TimeSeries::Samples& samples = series->series.samples;
      return {samples.data(), samples.data() + samples.size()};
    }
    const Controller& controller = *std::get<std::shared_ptr<const Controller>>(test.drive);
    std::vector<double> state(static_cast<std::size_t>(controller.state_size()), 0.0), all;
    std::vector<double> sensors(space_.sensors.size()), commands(space_.actuators.size());
    for (int period = 0; period * space_.control_period < test.duration; ++period) {
      const double time = period * space_.control_period;
      for (std::size_t s = 0; s < sensors.size(); ++s)
        sensors[s] = 3.0 * std::sin(kReadingRate * time + static_cast<double>(s));
      controller.act(time, sensors, state, commands);
      all.insert(all.end(), commands.begin(), commands.end());
    }
    return all;
  }

  TestSpace space_;
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const ModelEncoding& encoding, const ExerciseInputs&) {
  return std::make_unique<ModelEncodingExercise>(encoding);
}

std::unique_ptr<Exercise> exercise_of(const TestEncoding& encoding, const ExerciseInputs&) {
  return std::make_unique<TestEncodingExercise>(encoding);
}

}  // namespace lacuna
