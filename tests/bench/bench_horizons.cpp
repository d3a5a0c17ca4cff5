#include "app/rig.h"
#include "fitting/noise_floor.h"
#include "horizons/horizon_fit.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <memory>
#include <sstream>
#include <thread>

/// What sets of effects make of an experiment's errors over a ladder of horizons, fitted and held out. All sets are
/// fitted and scored by the same starts, lengths, floors and integration steps.
///
///   bench_horizons EXPERIMENT.toml ["EFFECT@WHERE EFFECT@WHERE" ...]
namespace lacuna {
namespace {

constexpr double kFineEnough = 0.02;  ///< nats that half the integration step may change the cost by
constexpr int kMostSubsteps = 64;

/// A model with everything that its errors are computed with.
struct Bench {
  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
  std::unique_ptr<TrialPredictor> predictor;
  std::unique_ptr<StartStates> states;
  std::unique_ptr<SmoothedStarts> starts;

  Bench(const Rig& rig, const std::string& effects, int substeps, const std::vector<ChannelNoise>& noise) {
    Experiment experiment = rig.experiment;
    std::istringstream words(effects);
    for (std::string word; words >> word;) {
      EffectEntry entry;
      entry.effect = word.substr(0, word.find('@'));
      entry.where = {word.substr(word.find('@') + 1)};
      entry.id = fmt::format("{}_{}", entry.effect, experiment.model.effects.size() + 1);
      experiment.model.effects.push_back(entry);
    }
    definition = define_model(experiment, *rig.catalog);
    definition.engine.substeps = substeps;
    model = compile(definition.structure, definition.engine);
    const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    predictor = std::make_unique<TrialPredictor>(*model, rig.trials, threads);
    states = std::make_unique<StartStates>(definition.structure.robot, *predictor, noise);
    starts = std::make_unique<SmoothedStarts>(*states, predictor->trials());
  }

  LadderTask task(const std::vector<ChannelNoise>& noise, const std::vector<double>& values, bool held_out) const {
    return {definition.structure.robot, *predictor, *states, *starts, noise, values, held_out};
  }
};

struct Score {
  HorizonFit fit;
  HorizonErrors held_out;
  double seconds = 0.0;
};

/// The ladder of the model as it is, and the substeps that it needs.
struct Setting {
  Ladder ladder;
  int substeps = 1;
};

Setting settle(const Rig& rig, const std::vector<ChannelNoise>& noise) {
  Setting setting;
  for (;; setting.substeps *= 2) {
    const Bench bench(rig, "", setting.substeps, noise), finer(rig, "", 2 * setting.substeps, noise);
    const ParameterSpace space(bench.definition.free);
    const std::vector<double> start = bench.definition.start_values();
    const Ladder rough = build_ladder(bench.task(noise, start, false));
    const std::vector<double> values = fit_to_ladder(rough, *bench.predictor, space, start).values;
    setting.ladder = build_ladder(bench.task(noise, values, false));
    const HorizonErrors now =
        errors_on(same_ladder(setting.ladder, bench.task(noise, values, false)), *bench.predictor, space, values);
    const HorizonErrors then =
        errors_on(same_ladder(setting.ladder, finer.task(noise, values, false)), *finer.predictor, space, values);
    const bool is_fine = now.valid && then.valid && std::abs(now.cost - then.cost) < kFineEnough;
    if (is_fine || setting.substeps >= kMostSubsteps) return setting;
  }
}

Score score(const Rig& rig, const std::string& effects, const Setting& setting, const std::vector<ChannelNoise>& noise,
            const Score* without) {
  const auto begin = std::chrono::steady_clock::now();
  const Bench bench(rig, effects, setting.substeps, noise);
  const std::vector<double> start = bench.definition.start_values();
  const ParameterSpace space(bench.definition.free);
  const Ladder ladder = same_ladder(setting.ladder, bench.task(noise, start, false));
  Score result;
  result.fit = fit_to_ladder(ladder, *bench.predictor, space, start);
  // Once more from the model without the effects, which a right minimum cannot lose to.
  if (without) {
    std::vector<double> beside = start;
    for (std::size_t i = 0; i < start.size(); ++i)
      for (std::size_t j = 0; j < rig.definition.free.size(); ++j)
        if (rig.definition.free[j].address == bench.definition.free[i].address) beside[i] = without->fit.values[j];
    HorizonFit other = fit_to_ladder(ladder, *bench.predictor, space, beside);
    const bool is_better = !result.fit.errors.valid || other.errors.cost < result.fit.errors.cost;
    if (other.errors.valid && is_better) result.fit = std::move(other);
  }
  result.held_out = errors_on(same_ladder(setting.ladder, bench.task(noise, start, true)), *bench.predictor, space,
                              result.fit.values);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

std::string errors_text(const HorizonErrors& errors, std::size_t rung) {
  std::string text;
  for (const double square : errors.mean_square[rung])
    text += (text.empty() ? "" : ", ") + (square > 0.0 ? fmt::format("{:.3g}", std::sqrt(square)) : std::string("–"));
  return text;
}

void print(const std::string& effects, const Score& score, const Score& base, const Ladder& ladder,
           const ModelDefinition& definition) {
  fmt::print("{}: ×{:.3f} fit, ×{:.3f} held out of the model as it is · {:.1f} s\n",
             effects.empty() ? "model as it is" : effects, std::exp(score.fit.errors.cost - base.fit.errors.cost),
             std::exp(score.held_out.cost - base.held_out.cost), score.seconds);
  for (std::size_t r = 0; r < ladder.rungs.size() && score.fit.errors.valid; ++r)
    fmt::print("  {:.3g} s: {} fit{}\n", ladder.rungs[r].length, errors_text(score.fit.errors, r),
               score.held_out.valid ? ", " + errors_text(score.held_out, r) + " held out" : "");
  for (std::size_t i = 0; i < definition.free.size(); ++i)
    fmt::print("  {} = {:.4g} {}\n", definition.free[i].address, score.fit.values[i], definition.free[i].unit);
}

void run(int argc, char** argv) {
  CommonOptions options;
  options.experiment = argv[1];
  const Rig rig = open_rig(options);
  const std::vector<ChannelNoise> noise = sensor_noise(rig.definition.structure.robot, rig.trials);
  const Setting setting = settle(rig, noise);
  fmt::print("channels");
  for (const ChannelNoise& channel : noise) fmt::print(" {} ({})", channel.channel, channel.unit);
  fmt::print(" · {} integration steps a step of the file\n", setting.substeps);
  const Score base = score(rig, "", setting, noise, nullptr);
  print("", base, base, setting.ladder, rig.definition);
  for (int i = 2; i < argc; ++i) {
    const Bench bench(rig, argv[i], setting.substeps, noise);
    print(argv[i], score(rig, argv[i], setting, noise, &base), base, setting.ladder, bench.definition);
  }
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "bench_horizons EXPERIMENT.toml [\"EFFECT@WHERE EFFECT@WHERE\" ...]\n");
    return EXIT_FAILURE;
  }
  try {
    lacuna::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
