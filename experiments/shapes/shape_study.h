#pragma once

#include "report/figures/figure.h"
#include "report/figures/robot_drawing.h"
#include "storage/eea/eea_records.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// The seed's e_o in the objective metric's rows: mean distance of the parts, m.
inline constexpr const char* kPartDistance = "body.*.position";
/// 1 where parts do not hang together as the target's do.
inline constexpr const char* kTopologyWrong = "topology_wrong";

/// A row's value of that name; NaN without one.
double objective_of(const PassRow& pass, const std::string& name);

/// With two digits and a unit that suits its size: "1.4 m", "18 µm".
std::string distance_text(double metres);

/// Which of these runs is the one to show: that whose last e_o is the median's, of an even number the smaller of the
/// two in the middle. Runs without a pass count as the worst. There must be at least one.
std::size_t typical_run(const std::vector<std::vector<PassRow>>& runs);

/// Whether some part of a robot of cylinders starts deeper in the ground than all of another robot, by more than
/// rounding; no robot need start on the ground.
bool starts_below(const RobotSpec& robot, const RobotSpec& reference);

/// The best model so far after a generation.
struct ProgressPoint {
  double generations = 0.0;  ///< since the run began
  double score = 0.0;        ///< e_s, on the trials of its pass
  double distance = 0.0;     ///< e_o, m
  int pass = 1;
};

/// What the replicates of one experiment found of a robot's shape.
struct ShapeStudy {
  std::string experiment;
  std::vector<std::vector<PassRow>> runs;
  double random_distance = 0.0;  ///< e_o of random models, mean over those that the runs began with
  std::size_t random_models = 0;
  double below_ground = 0.0;            ///< share of these with a part that starts deeper than the target
  std::int64_t typical = 1;             ///< number, in the database, of the run that is shown
  std::vector<ProgressPoint> progress;  ///< of the typical run
  std::vector<DrawnRobot> samples;      ///< of the typical run: random, best after passes, the target
  std::optional<double> trilaterated;   ///< e_o of centres from ranges alone, m, mean over runs
  double seconds = 0.0;                 ///< of work, all runs together
};

/// One line an experiment: e_o after the first and the last pass with 95 % intervals, over that of random models; how
/// often the topology is right; what trilateration gives.
std::string shape_table(const std::vector<ShapeStudy>& studies);

/// e_o and the share of right topologies by pass (the seed's Fig. 9). Means are those of the table. Where some are
/// far smaller than others, the axis of e_o is logarithmic, with the intervals of the means' logarithms; no interval
/// reaches below 0. Fewer than three runs have none.
Figure shape_errors(const std::vector<ShapeStudy>& studies);
/// e_s and e_o of the best model, generation by generation, of a typical run each (Fig. 8), with a line where a pass
/// begins.
Figure shape_progress(const std::vector<ShapeStudy>& studies);

}  // namespace lacuna
