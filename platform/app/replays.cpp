#include "app/replays.h"

#include "app/posed_robot.h"
#include "app/stored_model.h"
#include "foundation/interrupt.h"
#include "storage/canonical_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kFrame = 0.019;          ///< s between poses at least, so that a page shows about 50 a second
constexpr std::size_t kMostReplays = 60;  ///< simulated for a report

TimeSeries every(const TimeSeries& series, Eigen::Index stride) {
  const Eigen::Index count = (series.times.size() + stride - 1) / stride;
  TimeSeries thinned{series.channels, Eigen::VectorXd(count), TimeSeries::Samples(count, series.samples.cols())};
  for (Eigen::Index i = 0; i < count; ++i) {
    thinned.times[i] = series.times[i * stride];
    thinned.samples.row(i) = series.samples.row(i * stride);
  }
  return thinned;
}

Eigen::Index frame_stride(const Eigen::VectorXd& times) {
  if (times.size() < 2) return 1;
  const double step = (times[times.size() - 1] - times[0]) / static_cast<double>(times.size() - 1);
  return std::max<Eigen::Index>(1, static_cast<Eigen::Index>(kFrame / step) + 1);
}

/// The trials of a run, each once: the newest, the first, then those between.
std::vector<std::int64_t> by_interest(std::vector<std::int64_t> trials) {
  if (trials.size() > 2) std::rotate(trials.rbegin(), trials.rbegin() + 1, trials.rend());
  if (trials.size() > 2) std::reverse(trials.begin() + 2, trials.end());
  return trials;
}

}  // namespace

Replays::Replays(std::filesystem::path database, std::vector<std::filesystem::path> plugin_paths, PageDatabase& pages)
    : database_(std::move(database)), plugin_paths_(std::move(plugin_paths)), pages_(pages) {}

const StoredBench& Replays::bench_of(const Database& database, const EeaRunListing& run) {
  const auto known = benches_.find(run.run.value);
  if (known != benches_.end() && known->second.listing.experiment == run.experiment) return known->second;
  return benches_.insert_or_assign(run.run.value, open_stored(database, run, plugin_paths_)).first->second;
}

void Replays::prepare(std::int64_t run, std::int64_t trial) {
  const std::lock_guard lock(working_);
  const Database database = Database::open_read_only(database_);
  simulate(database, choose_run(database, run), trial);
}

void Replays::simulate(const Database& database, const EeaRunListing& run, std::int64_t trial) {
  const StoredBench& stored = bench_of(database, run);
  std::mutex unused;
  const EeaStore store(const_cast<Database&>(database), unused, run.run, {});
  const std::vector<PassRow> passes = store.passes();
  const auto best = std::find_if(passes.rbegin(), passes.rend(), [](const PassRow& pass) { return pass.best_model; });
  if (best == passes.rend()) throw Error(fmt::format("no pass of run {} has ended", run.run.value));
  const auto number = static_cast<std::int64_t>(*best->best_model);
  if (pages_.has_replay(run.run.value, trial, number)) return;

  const EeaDefinition& definition = stored.bench->definition();
  const StoredModel model = stored_model(store, definition, *best->best_model);
  const auto at = std::find(model.numbers.begin(), model.numbers.end(), static_cast<int>(trial));
  if (at == model.numbers.end())
    throw Error(fmt::format("model {} of run {} was held against the trials {} only", number, run.run.value,
                            fmt::join(model.numbers, ", ")));
  const ScoredTrial& scored = model.trials[static_cast<std::size_t>(at - model.numbers.begin())];
  const Eigen::VectorXd& sampled = scored.trial.measured.times;
  const std::vector<double> times(sampled.begin(), sampled.end());
  const Eigen::Index stride = frame_stride(sampled);

  ModelStructure structure = definition.model.structure;
  if (model.model.robot) structure.robot = *model.model.robot;
  ReplayRecord replay{.experiment = run.experiment,
                      .run = run.run.value,
                      .trial = trial,
                      .pass = best->number,
                      .model = number,
                      .robot = canonical_text(structure.robot),
                      .traces = {}};
  PosedRobot::Motion motion =
      PosedRobot(structure, definition.model.engine).move(model.model.values, scored.test, times);
  replay.traces.emplace_back("model", every(motion.poses, stride));
  replay.traces.emplace_back("predicted", std::move(motion.readings));
  replay.traces.emplace_back("measured", scored.trial.measured);
  if (const ModelDefinition* target = stored.bench->target()) {
    // The commands that it received, so that noise in its sensors moves it as it did then.
    const Test received{scored.trial.commands, scored.test.duration, scored.test.start};
    const std::vector<double> hidden = stored.bench->hidden_values(run.replicate);
    const PosedRobot watched(target->structure, target->engine);
    replay.traces.emplace_back("target", every(watched.move(hidden, received, times).poses, stride));
    replay.target_robot = canonical_text(target->structure.robot);
  }
  pages_.add(replay);
}

void Replays::prepare_for_report(std::size_t most_bytes) {
  const std::lock_guard lock(working_);
  const Database database = Database::open_read_only(database_);
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::reverse(runs.begin(), runs.end());
  const std::size_t begin = pages_.size();
  std::size_t made = 0;
  bool newest = true;
  for (const EeaRunListing& run : runs) {
    if (run.passes_done == 0) continue;
    try {
      std::mutex unused;
      std::vector<std::int64_t> trials;
      for (const TargetTrialRow& row : EeaStore(const_cast<Database&>(database), unused, run.run, {}).trial_rows())
        if (!row.for_transfer && row.number < run.passes_done) trials.push_back(row.number);
      trials = by_interest(std::move(trials));
      if (!newest) trials.resize(std::min<std::size_t>(trials.size(), 1));
      for (const std::int64_t trial : trials) {
        throw_if_interrupted();
        if (made == kMostReplays || pages_.size() - begin > most_bytes) {
          pages_.add_note(fmt::format("Robots in motion are shown for {} trials of the newest runs.", made));
          return;
        }
        simulate(database, run, trial);
        ++made;
      }
      newest = false;
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      const std::string reason = error.what();
      pages_.add_note(
          fmt::format("The robots of run {} are not shown: {}", run.run.value, reason.substr(0, reason.find('\n'))));
      if (newest) return;  // the others would say the same
    }
  }
}

}  // namespace lacuna
