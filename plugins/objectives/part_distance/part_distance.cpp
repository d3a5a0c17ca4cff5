#include <lacuna/error.h>
#include <lacuna/objective_metric.h>
#include <lacuna/plugin.h>

#include "junctions.h"

namespace lacuna {

/// Distances of a model's parts from those of the target (the origins of their frames, which position sensors read), in
/// their start pose (Eq. 3 of the seed), and whether they are connected in the same way.
class PartDistance : public ObjectiveMetric {
 public:
  std::string summary() const override;
  /// `body.<name>.position` of each part, m; their mean `body.*.position`, which is e_o; `topology_wrong`, 0 or 1.
  /// Parts are matched by index. Throws `Error` where model and target have different numbers of parts.
  std::vector<ObjectiveScore> score(const ModelSpace& space, const ModelProposal& model, const HiddenTruth& truth,
                                    std::span<const double> parameters) const override;
};

std::string PartDistance::summary() const {
  return "Distance of each part's centre from the target's at the start, its mean, and whether the topology is wrong";
}

std::vector<ObjectiveScore> PartDistance::score(const ModelSpace& space, const ModelProposal& model,
                                                const HiddenTruth& truth, std::span<const double>) const {
  const RobotSpec& found = model.robot ? *model.robot : space.robot;
  if (found.bodies.size() != truth.robot.bodies.size() || found.bodies.empty())
    throw Error("a model of " + std::to_string(found.bodies.size()) + " parts cannot be compared with a target of " +
                std::to_string(truth.robot.bodies.size()) + "; both must have the same number");
  std::vector<ObjectiveScore> scores;
  double sum = 0.0;
  for (std::size_t i = 0; i < found.bodies.size(); ++i) {
    const double distance = (found.bodies[i].position - truth.robot.bodies[i].position).norm();
    scores.push_back({"body." + truth.robot.bodies[i].name + ".position", "m", distance});
    sum += distance;
  }
  scores.push_back({"body.*.position", "m", sum / static_cast<double>(found.bodies.size())});
  scores.push_back({"topology_wrong", "1", junctions(found) == junctions(truth.robot) ? 0.0 : 1.0});
  return scores;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::ObjectiveMetric, lacuna::PartDistance>("part_distance"))
