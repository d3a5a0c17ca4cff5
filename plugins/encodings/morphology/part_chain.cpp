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

}  // namespace

std::vector<PlacedPart> place_parts(std::span<const double> genome, const ChainSettings& settings) {
  std::vector<PlacedPart> parts(genome.size() / kGenesPerPart);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::span<const double> genes = genome.subspan(i * kGenesPerPart, kGenesPerPart);
    PlacedPart& part = parts[i];
    part.length = settings.least_length + genes[kLengthGene] * (settings.greatest_length - settings.least_length);
    part.touch = genes[kTouchGene] >= 0.5;
    if (i == 0) {
      part.tail = {-0.5 * part.length, 0.0, settings.root_height};
      continue;
    }
    part.parent = settings.whole ? static_cast<std::size_t>(genes[kParentGene]) : scaled_index(genes[kParentGene], i);
    part.at_head = genes[kEndGene] >= 0.5;
    const PlacedPart& parent = parts[part.parent];
    part.tail = part.at_head ? parent.head() : parent.tail;
    part.orientation =
        turned(parent.orientation, std::numbers::pi * genes[kRollGene], std::numbers::pi * genes[kTurnGene]);
  }
  return parts;
}

double lowest_point(const PlacedPart& part, double radius) {
  const double slope = part.direction().z();
  return part.centre().z() - 0.5 * part.length * std::abs(slope) -
         radius * std::sqrt(std::max(0.0, 1.0 - slope * slope));
}

}  // namespace lacuna
