#include "app/runs/replays.h"

#include "app/runs/posed_robot.h"
#include "evaluation/model/proposed_model.h"
#include "foundation/processes/stop.h"
#include "storage/core/canonical_text.h"
#include "storage/core/without_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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
  if (trials.size() > 1) std::rotate(trials.rbegin(), trials.rbegin() + 1, trials.rend());
  if (trials.size() > 2) std::reverse(trials.begin() + 2, trials.end());
  return trials;
}

void add_motion(ReplayRecord& replay, const std::string& whose, const PosedRobot::Motion& motion, Eigen::Index stride) {
  replay.traces.emplace_back(whose, every(motion.poses, stride));
  if (!motion.contacts.channels.empty())
    replay.traces.emplace_back(whose + " contacts", every(motion.contacts, stride));
}

/// The first line of a fault, for whoever is sent a report.
std::string in_a_note(const std::string& fault) { return without_folders(fault.substr(0, fault.find('\n'))); }

}  // namespace

Replays::Replays(std::filesystem::path database, std::vector<std::filesystem::path> plugin_paths, PageDatabase& pages,
                 const Stop& stop)
    : database_(std::move(database)), plugin_paths_(std::move(plugin_paths)), stop_(stop), pages_(pages) {}

const OpenStoredRun& Replays::bench_of(const Database& database, const EeaRunListing& run) {
  const auto known = benches_.find(run.identity);
  if (known != benches_.end()) return known->second;
  return benches_.insert_or_assign(run.identity, open_stored(database, run, plugin_paths_)).first->second;
}

Replays::Subject Replays::subject_of(Database& database, const EeaRunListing& run) {
  const OpenStoredRun& stored = bench_of(database, run);
  std::mutex unused;
  const EeaStore store(database, unused, run.run, {});
  const std::vector<PassRow> passes = store.passes();
  const auto best = std::find_if(passes.rbegin(), passes.rend(), [](const PassRow& pass) { return pass.best_model; });
  if (best == passes.rend()) throw Error(fmt::format("run {} has no finished pass", run.run.value));
  const EeaDefinition& definition = stored.opened->definition();
  return {stored, run, best->number, stored_model(store, definition, *best->best_model, stop_),
          run_trials(store, definition)};
}

ScoredTrial Replays::trial_of(const Subject& subject, std::int64_t trial) {
  const std::vector<int>& fitted = subject.model.numbers;
  const auto known = std::find(fitted.begin(), fitted.end(), static_cast<int>(trial));
  if (known != fitted.end()) return subject.model.trials[static_cast<std::size_t>(known - fitted.begin())];
  for (const RunTrial& one : subject.trials)
    if (one.row.number == trial) return as_new_trial(one);
  throw Error(fmt::format("run {} has no trial {}; it has {}", subject.run.run.value, trial, subject.trials.size()));
}

std::int64_t Replays::prepare(std::int64_t run, std::int64_t trial) {
  const std::lock_guard lock(working_);
  Database database = Database::open_read_only(database_, stop_);
  return find_or_simulate(subject_of(database, choose_run(database, run)), trial);
}

std::int64_t Replays::find_or_simulate(const Subject& subject, std::int64_t trial) {
  const auto model = static_cast<std::int64_t>(subject.model.number);
  const std::optional<std::int64_t> known = pages_.find_replay(subject.run.identity, trial, model);
  return known ? *known : pages_.add(simulate(subject, trial));
}

ReplayRecord Replays::simulate(const Subject& subject, std::int64_t trial) const {
  const StoredModel& model = subject.model;
  const ScoredTrial scored = trial_of(subject, trial);
  const std::vector<double> times(scored.trial.measured.times.begin(), scored.trial.measured.times.end());
  const Eigen::Index stride = frame_stride(scored.trial.measured.times);

  const OpenEeaRun& opened = *subject.stored.opened;
  const ModelDefinition& definition = opened.definition().model;
  const ModelStructure structure = structure_of(model.model, definition);
  ReplayRecord replay{.experiment = subject.run.experiment,
                      .identity = subject.run.identity,
                      .run = subject.run.run.value,
                      .trial = trial,
                      .pass = subject.pass,
                      .model = static_cast<std::int64_t>(model.number),
                      .robot = canonical_text(structure.robot),
                      .traces = {}};
  PosedRobot::Motion motion = PosedRobot(structure, definition.engine, stop_)
                                  .move(structure_values(model.model, definition), scored.test, times);
  add_motion(replay, "model", motion, stride);
  replay.traces.emplace_back("predicted", std::move(motion.readings));
  replay.traces.emplace_back("measured", scored.trial.measured);
  if (const ModelDefinition* target = opened.target()) {
    // The commands that it received, so that noise in its sensors moves it as it did then.
    const Test received{scored.trial.commands, scored.test.duration, scored.test.start};
    const std::vector<double> hidden = opened.hidden_values(subject.run.replicate);
    add_motion(replay, "target", PosedRobot(target->structure, target->engine, stop_).move(hidden, received, times),
               stride);
    replay.target_robot = canonical_text(target->structure.robot);
  }
  return replay;
}

std::size_t Replays::prepare_run(const Subject& subject, std::size_t most_trials, std::size_t most_bytes) {
  std::vector<std::int64_t> trials;
  for (const RunTrial& one : subject.trials) trials.push_back(one.row.number);
  trials = by_interest(std::move(trials));
  std::size_t made = 0;
  std::string fault;
  for (const std::int64_t trial : trials) {
    stop_.throw_if_due();
    if (made == most_trials || pages_.size() > most_bytes) break;
    try {
      find_or_simulate(subject, trial);
      ++made;
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      if (fault.empty()) fault = fmt::format("trial {} of run {}: {}", trial, subject.run.run.value, error.what());
    }
  }
  if (!fault.empty()) pages_.add_note("The page Replay has no robots: " + in_a_note(fault));
  return made;
}

void Replays::prepare_for_report(std::size_t most_bytes) {
  const std::lock_guard lock(working_);
  Database database = Database::open_read_only(database_, stop_);
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::reverse(runs.begin(), runs.end());
  most_bytes += pages_.size();
  std::size_t made = 0;
  const auto is_full = [&] { return made >= kMostReplays || pages_.size() > most_bytes; };
  std::set<std::string> failed;  // experiments, whose other runs would say the same
  for (const EeaRunListing& run : runs) {
    if (run.passes_done == 0 || failed.contains(run.experiment) || is_full()) continue;
    try {
      made += prepare_run(subject_of(database, run), made == 0 ? kMostReplays : 1, most_bytes);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      failed.insert(run.experiment);
      pages_.add_note(fmt::format("The robots of run {} are not shown: {}", run.run.value, in_a_note(error.what())));
    }
  }
  if (is_full())
    pages_.add_note(fmt::format("The page Replay shows robots only for {} trials of the newest runs.", made));
}

}  // namespace lacuna
