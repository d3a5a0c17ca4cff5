#include "diagnosis/integration_error.h"

#include "foundation/parallel.h"

#include <optional>

namespace lacuna {
namespace {

constexpr int kFinest = 8;  ///< times as many substeps

using Predictions = std::vector<TimeSeries::Samples>;

/// By segment; nothing where one cannot be simulated.
std::optional<Predictions> predictions(const ModelDefinition& definition, int substeps, const BaseSolution& base,
                                       int threads) {
  EngineSettings engine = definition.engine;
  engine.substeps = substeps;
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, engine);
  const TrialPredictor predictor(*model, base.trials, threads);
  std::vector<Prediction> all(base.segments.size());
  parallel_for(all.size(), predictor.workers(), [&](std::size_t k, int worker) {
    const Segment& segment = base.segments[k];
    StartState start = segment.start;
    for (std::size_t j = 0; j < segment.unknown.size(); ++j)
      set_component(start, segment.unknown[j], base.states[k](static_cast<Eigen::Index>(j)));
    predictor.predict(segment.stretch, base.values, start, worker, all[k]);
  });
  Predictions samples;
  for (Prediction& prediction : all) {
    if (!prediction.valid) return std::nullopt;
    samples.push_back(std::move(prediction.samples));
  }
  return samples;
}

}  // namespace

bool correct_for_steps(const ModelDefinition& definition, BaseSolution& base, int threads) {
  if (base.free_run) return false;
  const int substeps = definition.engine.substeps;
  const auto own = predictions(definition, substeps, base, threads);
  const auto fine = predictions(definition, kFinest / 2 * substeps, base, threads);
  const auto finest = predictions(definition, kFinest * substeps, base, threads);
  if (!own || !fine || !finest) return false;
  for (std::size_t k = 0; k < base.segments.size(); ++k) {
    const Stretch& stretch = base.segments[k].stretch;
    const Eigen::Index run_in = base.segments[k].run_in, counted = stretch.size() - run_in;
    const TimeSeries::Samples limit = 2.0 * (*finest)[k] - (*fine)[k];  // the engine is of first order
    base.trials[stretch.trial].measured.samples.middleRows(stretch.first + run_in, counted) -=
        (limit - (*own)[k]).bottomRows(counted);
  }
  return true;
}

}  // namespace lacuna
