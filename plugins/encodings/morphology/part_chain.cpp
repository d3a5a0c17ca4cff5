#include "part_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

using Eigen::Vector3d;

std::size_t scaled_index(double gene, std::size_t count) {
  return std::min(static_cast<std::size_t>(gene * static_cast<double>(count)), count - 1);
}

Eigen::Quaterniond turned(const Eigen::Quaterniond& parent, double roll, double turn) {
  return (parent * Eigen::AngleAxisd(roll, Vector3d::UnitX()) * Eigen::AngleAxisd(turn, Vector3d::UnitZ()))
      .normalized();
}

/// A part from its row, given the parts before it.
PlacedPart placed(std::size_t i, std::span<const double> genes, const std::vector<PlacedPart>& parts,
                  double root_height) {
  PlacedPart part;
  part.length = genes[kLengthGene];
  part.touch = genes[kTouchGene] >= 0.5;
  if (i == 0) {
    part.tail = {-0.5 * part.length, 0.0, root_height};
    return part;
  }
  part.parent = scaled_index(genes[kParentGene], i);
  part.at_head = genes[kEndGene] >= 0.5;
  const PlacedPart& parent = parts[part.parent];
  part.tail = part.at_head ? parent.head() : parent.tail;
  part.orientation =
      turned(parent.orientation, std::numbers::pi * genes[kRollGene], std::numbers::pi * genes[kTurnGene]);
  return part;
}

/// The row of a part with the same parent that puts its centre at this place. For a centre in the half of all
/// directions that genes cannot express, the nearest point on the boundary plane is used.
void aim(const PlacedPart& part, const PlacedPart& parent, const Vector3d& centre, const Gene& length,
         std::span<double> genes) {
  Vector3d way = parent.orientation.conjugate() * (centre - part.tail);  // in the parent's frame
  if (!(way.z() > 0.0)) way.z() = 0.0;
  genes[kLengthGene] = std::clamp(2.0 * way.norm(), length.lower, length.upper);
  const double aside = std::hypot(way.y(), way.z());
  genes[kTurnGene] = std::atan2(aside, way.x()) / std::numbers::pi;
  if (aside > 0.0) genes[kRollGene] = std::atan2(way.z(), way.y()) / std::numbers::pi;  // otherwise any does
}

}  // namespace

std::vector<PlacedPart> place_parts(std::span<const double> genome, double root_height) {
  std::vector<PlacedPart> parts(genome.size() / kGenesPerPart);
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] = placed(i, genome.subspan(i * kGenesPerPart, kGenesPerPart), parts, root_height);
  return parts;
}

std::string topology_of(const std::vector<PlacedPart>& parts) {
  std::vector<std::size_t> tails(parts.size(),
                                 0);  // position of each part's tail: 0 the first one's, k + 1 the k-th head
  std::string text;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    tails[i] = parts[i].at_head ? parts[i].parent + 1 : tails[parts[i].parent];
    if (i > 1) text += ' ';
    text += tails[i] == 0 ? "0t" : std::to_string(tails[i] - 1) + 'h';
  }
  return text;
}

void aim_at_centres(std::span<double> genome, std::span<const Gene> genes, std::span<const Vector3d> centres,
                    double root_height) {
  std::vector<PlacedPart> parts(genome.size() / kGenesPerPart);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t first = i * kGenesPerPart;
    const std::span<double> row = genome.subspan(first, kGenesPerPart);
    parts[i] = placed(i, row, parts, root_height);
    if (i == 0) continue;
    aim(parts[i], parts[parts[i].parent], centres[i], genes[first + kLengthGene], row);
    parts[i] = placed(i, row, parts, root_height);
  }
}

double parent_gene(std::size_t parent, std::size_t part) {
  return (static_cast<double>(parent) + 0.5) / static_cast<double>(part);
}

double end_gene(bool at_head) { return at_head ? 0.75 : 0.25; }

}  // namespace lacuna
