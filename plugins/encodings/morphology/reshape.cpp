#include "reshape.h"

#include "part_chain.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using Eigen::Vector3d;

enum Parameter : std::size_t { kReattach, kStretch, kRegular, kCoarsest, kFinest };

constexpr std::size_t kAttempts = 20;
constexpr double kRootHeight = 0.0;  // m; the position of the robot does not matter here

void check(const GenomeLayout& layout, std::span<const double> parameters) {
  if (layout.row != kGenesPerPart || layout.size() < 2 * kGenesPerPart)
    throw Error("reshape varies rows of six genes, as made by the encoding morphology with an empty model.free");
  for (std::size_t i = 0; i < layout.size(); ++i)
    if (i % kGenesPerPart != kLengthGene && (layout.genes[i].lower != 0.0 || layout.genes[i].upper != 1.0))
      throw Error("reshape varies lengths and genes from 0 to 1, as made by the encoding morphology");
  if (parameters[kCoarsest] > parameters[kFinest])
    throw Error("coarsest must be at most finest: both count decades below a metre");
}

/// From 10^-finest to 10^-coarsest m, each decade with the same chance.
double step_size(std::span<const double> parameters, RandomStream& random) {
  return std::pow(10.0, -random.uniform(parameters[kCoarsest], parameters[kFinest]));
}

/// Half of the moves go along x, y or z. Beacons on the ground hardly measure a height, so moves that change it
/// together with the well-measured position rarely succeed.
Vector3d any_direction(RandomStream& random) {
  if (random.chance(0.5)) {
    const double sign = random.chance(0.5) ? 1.0 : -1.0;
    return sign * Vector3d::Unit(static_cast<Eigen::Index>(random.index(3)));
  }
  const double x = random.normal(), y = random.normal(), z = random.normal();
  const Vector3d direction(x, y, z);
  return direction.norm() > 0.0 ? Vector3d(direction.normalized()) : Vector3d::UnitX();
}

/// Another parent or end.
void hang_elsewhere(std::span<double> genome, std::size_t part, const PlacedPart& now, RandomStream& random) {
  for (std::size_t attempt = 0; attempt < kAttempts; ++attempt) {
    const std::size_t parent = random.index(part);
    const bool at_head = random.chance(0.5);
    if (parent == now.parent && at_head == now.at_head) continue;
    genome[part * kGenesPerPart + kParentGene] = parent_gene(parent, part);
    genome[part * kGenesPerPart + kEndGene] = end_gene(at_head);
    return;
  }
}

/// Copies one coordinate of another part's centre, or its negative.
void line_up(std::vector<Vector3d>& centres, std::size_t part, RandomStream& random) {
  const std::size_t draw = random.index(centres.size() - 1);
  const std::size_t other = draw + (draw >= part ? 1 : 0);
  const auto axis = static_cast<Eigen::Index>(random.index(3));
  const bool mirrored = axis != 2 && random.chance(0.5);  // there is nothing below the ground
  centres[part][axis] = mirrored ? -centres[other][axis] : centres[other][axis];
}

}  // namespace

std::string Reshape::summary() const {
  return "For morphology: attaches a part elsewhere or moves its centre; the centres of the others stay";
}

ParameterDeclarations Reshape::parameters() const {
  return {{"reattach", "1", 0.3, 0.0, 1.0, Scale::linear, "Probability that a part is attached elsewhere"},
          {"stretch", "1", 0.15, 0.0, 1.0, Scale::linear,
           "Probability that otherwise the first part, whose centre is fixed, gets another length"},
          {"regular", "1", 0.3, 0.0, 1.0, Scale::linear,
           "Probability that a move copies a coordinate or length of another part instead of being random"},
          {"coarsest", "1", 0.0, -3.0, 15.0, Scale::linear, "Decades below a metre, for the largest move"},
          {"finest", "1", 5.0, -3.0, 15.0, Scale::linear, "Decades below a metre, for the smallest move"}};
}

Genome Reshape::vary(std::span<const Genome> parents, const GenomeLayout& layout, std::span<const double> parameters,
                     RandomStream& random) const {
  check(layout, parameters);
  Genome child = parents.front();
  const std::vector<PlacedPart> parts = place_parts(child, kRootHeight);
  std::vector<Vector3d> centres;
  for (const PlacedPart& part : parts) centres.push_back(part.centre());
  const std::size_t part = 1 + random.index(parts.size() - 1);
  if (random.chance(parameters[kReattach])) {
    hang_elsewhere(child, part, parts[part], random);
  } else if (random.chance(parameters[kStretch])) {
    double metres = step_size(parameters, random) * (random.chance(0.5) ? 1.0 : -1.0);
    if (random.chance(parameters[kRegular])) metres = 0.5 * (parts[part].length - parts[0].length);
    const Gene& length = layout.genes[kLengthGene];
    child[kLengthGene] = std::clamp(child[kLengthGene] + metres, length.lower, length.upper);
  } else if (random.chance(parameters[kRegular])) {
    line_up(centres, part, random);
  } else {
    centres[part] += step_size(parameters, random) * any_direction(random);
  }
  aim_at_centres(child, layout.genes, centres, kRootHeight);
  return child;
}

}  // namespace lacuna
