#include "bench/scored_quadruped.h"

#include "bench/bench_quadruped.h"
#include "bench/platform_quadruped.h"

#include <lacuna/error.h>

namespace lacuna {

ScoredQuadruped::ScoredQuadruped() {
  ModelStructure structure;
  structure.robot = bench_quadruped();
  for (const BodySpec& body : structure.robot.bodies) {
    structure.parameters.push_back({"body." + body.name + ".mass", 0.5, 2.0});
    masses_.push_back(body.mass);
  }
  EngineSettings settings;
  settings.step = kBenchStep;
  model_ = compile(structure, settings);
}

void ScoredQuadruped::run(int steps) {
  if (steps != steps_) {
    steps_ = steps;
    PlatformQuadruped measured;
    measured.run(steps);
    ScoredTrial scored;
    scored.test = measured.test();
    scored.trial.name = "measured";
    scored.trial.measured = measured.result().readings;
    static const PluginCatalog catalog({LACUNA_PLUGINS_DIRECTORY});
    const Chosen<FitnessMetric> metric{&catalog.get<FitnessMetric>("mean_absolute_difference"), {}, {}};
    scorer_ = std::make_unique<ModelScorer>(*model_, std::vector<ScoredTrial>{scored}, metric, Work{1});
  }
  scorer_->score({masses_}, std::nullopt, 0, score_);
  if (score_.kind != ScoreKind::full || score_.total != 0.0) throw Error("the same quadruped scores another motion");
}

}  // namespace lacuna
