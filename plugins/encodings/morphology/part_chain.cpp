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

/// A part as its row says it, where those before it lie.
PlacedPart placed(std::size_t i, std::span<const double> genes, const std::vector<PlacedPart>& parts,
                  const ChainSettings& settings) {
  PlacedPart part;
  part.length = settings.least_length + genes[kLengthGene] * (settings.greatest_length - settings.least_length);
  part.touch = genes[kTouchGene] >= 0.5;
  if (i == 0) {
    part.tail = {-0.5 * part.length, 0.0, settings.root_height};
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

/// What the row of a part that hangs where it does would have to be for its centre to be there.
void aim(const PlacedPart& part, const PlacedPart& parent, const Vector3d& centre, const ChainSettings& settings,
         std::span<double> genes) {
  const Vector3d way = parent.orientation.conjugate() * (centre - part.tail);  // in the parent's frame
  const double distance = way.norm(), range = settings.greatest_length - settings.least_length;
  if (!(distance > 0.0)) return;
  if (range > 0.0) genes[kLengthGene] = std::clamp((2.0 * distance - settings.least_length) / range, 0.0, 1.0);
  genes[kTurnGene] = std::acos(std::clamp(way.x() / distance, -1.0, 1.0)) / std::numbers::pi;
  if (way.y() == 0.0 && way.z() == 0.0) return;  // any roll does
  // What lies in the other half of all directions comes as near as the plane between the two halves.
  genes[kRollGene] = way.z() >= 0.0 ? std::atan2(way.z(), way.y()) / std::numbers::pi : way.y() >= 0.0 ? 0.0 : 1.0;
}

}  // namespace

std::vector<PlacedPart> place_parts(std::span<const double> genome, const ChainSettings& settings) {
  std::vector<PlacedPart> parts(genome.size() / kGenesPerPart);
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] = placed(i, genome.subspan(i * kGenesPerPart, kGenesPerPart), parts, settings);
  return parts;
}

void aim_at_centres(std::span<double> genome, std::span<const Vector3d> centres, const ChainSettings& settings) {
  std::vector<PlacedPart> parts(genome.size() / kGenesPerPart);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::span<double> genes = genome.subspan(i * kGenesPerPart, kGenesPerPart);
    parts[i] = placed(i, genes, parts, settings);
    if (i == 0) continue;
    aim(parts[i], parts[parts[i].parent], centres[i], settings, genes);
    parts[i] = placed(i, genes, parts, settings);
  }
}

double parent_gene(std::size_t parent, std::size_t part) {
  return (static_cast<double>(parent) + 0.5) / static_cast<double>(part);
}

double end_gene(bool at_head) { return at_head ? 0.75 : 0.25; }

double lowest_point(const PlacedPart& part, double radius) {
  const double slope = part.direction().z();
  return part.centre().z() - 0.5 * part.length * std::abs(slope) -
         radius * std::sqrt(std::max(0.0, 1.0 - slope * slope));
}

}  // namespace lacuna
