#include <lacuna/cylinder.h>
#include <lacuna/error.h>
#include <lacuna/model_encoding.h>
#include <lacuna/plugin.h>
#include <lacuna/value_genes.h>

#include "part_chain.h"
#include "reshape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

namespace lacuna {

/// Robots as genomes: one row of six genes per cylinder, which give its parent, the end of the parent, its length, its
/// direction and whether it has a touch sensor (Bongard and Lipson, experiment 2). The README has the equations.
class Morphology : public ModelEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where the robot does not consist of cylinders each on a hinge, the lengths are in the wrong order,
  /// or the scale of a touch sensor is free.
  GenomeLayout layout(const ModelSpace& space, std::span<const double> parameters) const override;
  ModelProposal decode(const ModelSpace& space, std::span<const double> parameters,
                       std::span<const double> genome) const override;
};

namespace {

using Eigen::Vector3d;

enum Parameter : std::size_t { kLeastLength, kGreatestLength, kVerticalAxis, kLift };

constexpr std::array<const char*, kGenesPerPart> kGeneNames = {"parent", "end", "length", "roll", "turn", "touch"};
constexpr double kVertical = 1e-6;  // sine of the angle to the vertical

void check_robot(const RobotSpec& robot) {
  const std::string needs = "; the encoding places cylinders, each but the first on its own hinge";
  if (robot.bodies.size() < 2) throw Error("the robot has fewer than two parts" + needs);
  if (robot.joints.size() != robot.bodies.size() - 1)
    throw Error("the robot has " + std::to_string(robot.joints.size()) + " joints for " +
                std::to_string(robot.bodies.size()) + " parts" + needs);
  for (const BodySpec& body : robot.bodies)
    if (body.shapes.size() != 1 || body.shapes[0].kind != ShapeKind::cylinder)
      throw Error("the body \"" + body.name + "\" is not one cylinder" + needs);
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].kind != JointKind::hinge || robot.joints[i].child != robot.bodies[i + 1].name)
      throw Error("the joint \"" + robot.joints[i].name + "\" is not the hinge that holds \"" +
                  robot.bodies[i + 1].name + "\"" + needs);
}

/// A touch sensor that no part asks for is switched off by its scale, which then belongs to the genome.
void check_free(const RobotSpec& robot, const std::vector<FreeParameter>& free) {
  for (const SensorSpec& sensor : robot.sensors)
    for (const FreeParameter& parameter : free)
      if (sensor.kind == SensorKind::touch && parameter.address == "sensor." + sensor.name + ".scale")
        throw Error("model.free names " + parameter.address +
                    ", with which the encoding switches a touch sensor off where no part has one; leave it out");
}

Gene gene_of(const BodySpec& body, std::size_t which, std::span<const double> parameters) {
  const std::string name = body.name + "." + kGeneNames[which];
  if (which == kLengthGene) return {name, "m", GeneKind::real, parameters[kLeastLength], parameters[kGreatestLength]};
  return {name, "1", GeneKind::real, 0.0, 1.0};
}

/// The body keeps its name, mass and radius.
void place_body(BodySpec& body, const PlacedPart& part) {
  ShapeSpec& shape = body.shapes[0];
  const double radius = shape.size.x();
  shape.size.y() = part.length;
  shape.position = Vector3d::Zero();
  shape.orientation = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitY());  // its z is the body's x
  body.com = Vector3d::Zero();
  body.inertia = solid_cylinder(body.mass, radius, part.length);
  body.position = part.centre();
  body.orientation = part.orientation;
}

Vector3d hinge_axis(const Vector3d& direction, bool sagittal_where_vertical) {
  const Vector3d axis = direction.cross(Vector3d::UnitZ());
  if (axis.norm() > kVertical) return axis.normalized();
  return sagittal_where_vertical ? Vector3d::UnitY() : Vector3d::UnitX();
}

/// Random numbers keyed by the decisions of a genome, so that changing a length or an angle does not change them.
RandomStream stream_of(const std::vector<PlacedPart>& parts) {
  std::vector<std::uint64_t> key;
  for (const PlacedPart& part : parts)
    key.push_back(4 * part.parent + (part.at_head ? 2U : 0U) + (part.touch ? 1U : 0U));
  return RandomStream(key);
}

/// Touch sensors go to the first parts that ask for one; the remaining ones go to any part and are switched off.
void place_touch_sensors(RobotSpec& robot, const std::vector<PlacedPart>& parts) {
  RandomStream random = stream_of(parts);
  std::size_t next = 0;
  for (SensorSpec& sensor : robot.sensors) {
    if (sensor.kind != SensorKind::touch) continue;
    while (next < parts.size() && !parts[next].touch) ++next;
    if (next == parts.size()) {
      sensor.element = robot.bodies[random.index(parts.size())].name;
      sensor.scale = 0.0;
      continue;
    }
    sensor.element = robot.bodies[next++].name;
  }
}

/// Raises the robot until no part is lower than a lying first part: on the ground, or as deep in it.
void lift(RobotSpec& robot) {
  const BodySpec& root = robot.bodies[0];
  const double floor = std::min(0.0, root.position.z() - root.shapes[0].size.x());
  double height = 0.0;
  for (const BodySpec& body : robot.bodies) height = std::max(height, floor - lowest_point(body, body.shapes[0]));
  for (BodySpec& body : robot.bodies) body.position.z() += height;
  for (JointSpec& joint : robot.joints) joint.anchor.z() += height;
}

}  // namespace

std::string Morphology::summary() const {
  return "Six genes per cylinder: parent, head or tail, length, two angles, touch sensor or none; builds the robot";
}

ParameterDeclarations Morphology::parameters() const {
  return {{"l_min", "m", 0.1, 1e-3, 100.0, Scale::linear, "Length of the shortest part"},
          {"l_max", "m", 2.0, 1e-3, 100.0, Scale::linear, "Length of the longest part"},
          {"vertical_axis", "1", 1.0, 0.0, 1.0, Scale::linear,
           "Hinge axis of a part that points up or down: 1: y, motion in the sagittal plane; 0: x"},
          {"lift", "1", 0.0, 0.0, 1.0, Scale::linear,
           "1: a robot with a part below the ground is raised until no part is lower than a lying first part; 0: it "
           "stays, and the contact pushes it out"}};
}

GenomeLayout Morphology::layout(const ModelSpace& space, std::span<const double> parameters) const {
  check_robot(space.robot);
  check_free(space.robot, space.free);
  if (parameters[kLeastLength] > parameters[kGreatestLength])
    throw Error("the shortest part is longer than the longest; give l_min at most l_max");
  for (const auto& [name, index] : {std::pair("vertical_axis", kVerticalAxis), std::pair("lift", kLift)})
    if (parameters[index] != std::floor(parameters[index])) throw Error(std::string(name) + " must be 0 or 1");
  GenomeLayout layout;
  for (const BodySpec& body : space.robot.bodies)
    for (std::size_t which = 0; which < kGenesPerPart; ++which)
      layout.genes.push_back(gene_of(body, which, parameters));
  layout.row = space.free.empty() ? kGenesPerPart : 0;
  append_value_genes(space.free, layout.genes);
  return layout;
}

ModelProposal Morphology::decode(const ModelSpace& space, std::span<const double> parameters,
                                 std::span<const double> genome) const {
  const std::size_t shape_genes = kGenesPerPart * space.robot.bodies.size();
  if (genome.size() != shape_genes + space.free.size())
    throw Error("a genome of " + std::to_string(genome.size()) + " genes does not fit a robot of " +
                std::to_string(space.robot.bodies.size()) + " parts and " + std::to_string(space.free.size()) +
                " free parameters");
  const std::vector<PlacedPart> parts = place_parts(genome.first(shape_genes), space.robot.bodies[0].position.z());
  auto robot = std::make_shared<RobotSpec>(space.robot);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    place_body(robot->bodies[i], parts[i]);
    if (i == 0) continue;
    JointSpec& joint = robot->joints[i - 1];
    joint.parent = robot->bodies[parts[i].parent].name;
    joint.anchor = parts[i].tail;
    joint.axis = hinge_axis(parts[i].direction(), parameters[kVerticalAxis] >= 0.5);
  }
  if (parameters[kLift] >= 0.5) lift(*robot);
  place_touch_sensors(*robot, parts);
  ModelProposal model;
  model.values = values_of_genes(space.free, genome.subspan(shape_genes));
  model.robot = std::move(robot);
  model.structure = topology_of(parts);
  return model;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::ModelEncoding, lacuna::Morphology>("morphology"),
              lacuna::component<lacuna::MutationOperator, lacuna::Reshape>("reshape"))
