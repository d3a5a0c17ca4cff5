#pragma once

#include <lacuna/genome.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

constexpr std::size_t kGenesPerPart = 6;

/// The genes of one part, in their order.
enum PartGene : std::size_t { kParentGene, kEndGene, kLengthGene, kRollGene, kTurnGene, kTouchGene };

/// One part as placed by its genes, world frame.
struct PlacedPart {
  std::size_t parent = 0;               ///< index of an earlier part; for the first part its own
  bool at_head = false;                 ///< end of the parent at which its tail is
  double length = 0.0;                  ///< m
  bool touch = false;                   ///< asks for a touch sensor
  Eigen::Vector3d tail{0.0, 0.0, 0.0};  ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< its x points from tail to head

  Eigen::Vector3d direction() const { return orientation * Eigen::Vector3d::UnitX(); }
  Eigen::Vector3d centre() const { return tail + 0.5 * length * direction(); }
  Eigen::Vector3d head() const { return tail + length * direction(); }
};

/// The parts of a genome of `kGenesPerPart` genes each: lengths in m, all others within [0, 1]. The first lies along x
/// with its centre at `root_height` above the origin, m.
std::vector<PlacedPart> place_parts(std::span<const double> genome, double root_height);

/// Which ends meet, as in "0h 0t 2h": for each part but the first, the part, counted from 0, to whose head or tail it
/// is attached. A part attached to the tail of another part is at the place of that part's attachment, so equal texts
/// are equal topologies.
std::string topology_of(const std::vector<PlacedPart>& parts);

/// Sets the genes of length, roll and turn of every part but the first so that its centre is as near to the given one
/// as the genes' bounds allow, given the parts before it; parents, ends and the first part's length stay. `genes` are
/// the layout's, with the bounds of lengths.
void aim_at_centres(std::span<double> genome, std::span<const Gene> genes, std::span<const Eigen::Vector3d> centres,
                    double root_height);

/// The gene of a parent, or of an end, in the middle of its interval.
double parent_gene(std::size_t parent, std::size_t part);
double end_gene(bool at_head);

}  // namespace lacuna
