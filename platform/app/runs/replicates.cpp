#include "app/runs/replicates.h"

#include "app/runs/claim_beats.h"
#include "app/runs/store_journal.h"
#include "foundation/parallel.h"
#include "foundation/processes/process_limits.h"
#include "isolation/remote_evaluations.h"
#include "storage/core/run_claim.h"
#include "storage/core/storage_error.h"
#include "storage/results/result_store.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

std::vector<std::string> names_of(const GenomeLayout& layout) {
  std::vector<std::string> names;
  for (const Gene& gene : layout.genes) names.push_back(gene.name);
  return names;
}

/// Passes the rows on, and what they say about trials and passes to the display.
class ShownJournal : public StoreJournal {
 public:
  ShownJournal(EeaStore& store, RunDisplay& display, std::size_t index)
      : StoreJournal(store), display_(display), index_(index) {}
  using StoreJournal::add;
  void add(TargetTrialRow row, const Trial& trial) override {
    display_.end_trial(index_, row);
    StoreJournal::add(std::move(row), trial);
  }
  void note_failure(const FailedTrialRecord& failed) override {
    display_.note(index_, "trial " + failed.trial + " failed: " + failed.reason);
    StoreJournal::note_failure(failed);
  }
  void note(const std::string& sentence) override { display_.note(index_, sentence); }
  void add(PassRow row) override {
    display_.end_pass(index_, row);
    StoreJournal::add(std::move(row));
  }

 private:
  RunDisplay& display_;
  std::size_t index_;
};

/// A rig carries out one trial at a time.
int most_side_by_side(const OpenEeaRun& opened) {
  const TargetSection& target = opened.opened().experiment.target;
  return target.kind == "process" ? target.process.copies : std::numeric_limits<int>::max();
}

void fail(ReplicateEnd& end, const std::exception& error) {
  end.ending = RunEnding::failed;
  end.damaged = end.damaged || dynamic_cast<const DamagedDatabase*>(&error) != nullptr;
  if (end.problem.empty()) end.problem = failure_sentence(error);
}

/// What was committed stays, whatever cannot be written any more.
void close(EeaStore& store, ReplicateEnd& end) {
  try {
    if (!end.began)
      store.hand_over();
    else if (end.ending != RunEnding::done)
      store.end(end.ending);
    end.passes = store.passes();
  } catch (const std::exception& error) {
    fail(end, error);
  }
}

}  // namespace

EeaRunRecord Replicates::record(int replicate) const {
  const EeaDefinition& definition = opened_.definition();
  EeaRunRecord record;
  record.replicate = replicate;
  record.metric = definition.metric.origin.name;
  record.truth = opened_.truth(replicate);
  for (const FreeValue& value : definition.model.free)
    record.free.push_back({value.address, value.unit, value.lower, value.upper, value.start});
  record.model_genes = names_of(definition.estimation.layout());
  record.passes = definition.passes;
  if (!opened_.takes_tests()) return record;
  record.fitness = definition.value.name();
  record.fitness_unit = definition.value.unit();
  record.test_genes = names_of(definition.exploration.layout());
  return record;
}

void Replicates::enter(const std::vector<PlannedReplicate>& planned) {
  for (const PlannedReplicate& each : planned) {
    EeaStore store(database_, writing_, each.run, experiment_);
    store.begin(record(each.replicate));
    store.hand_over();
  }
}

EeaState Replicates::state_of(EeaStore& store) const {
  if (std::optional<EeaState> state = stored_state(store, opened_.definition())) return std::move(*state);
  EeaState state = beginning(opened_);
  for (std::size_t i = 0; i < state.trials.size(); ++i)
    store.append({.number = static_cast<int>(i), .test = {}, .file = state.trials[i].trial.name},
                 state.trials[i].trial);
  return state;
}

void Replicates::carry_out(std::size_t index, int threads, RunDisplay& display, ReplicateEnd& end) {
  const auto start = std::chrono::steady_clock::now();
  const PlannedReplicate& planned = end.planned;
  EeaStore store(database_, writing_, planned.run, experiment_);
  try {
    const Stop& stop = opened_.opened().stop;
    end.began = !stop.is_due();
    stop.throw_if_due();
    EeaState state = state_of(store);
    ShownJournal journal(store, display, index);
    const ReplicateTarget target(opened_, planned.seed, planned.replicate,
                                 [&](const std::string& note) { display.note(index, note); });
    std::optional<RemoteEvaluations> elsewhere;
    if (workers_) elsewhere.emplace(*workers_, threads);
    eea_loop({.definition = opened_.definition(),
              .journal = journal,
              .seed = planned.seed,
              .replicate = planned.replicate,
              .work = {threads, stop},
              .truth = opened_.truth(planned.replicate),
              .target = opened_.target() ? &opened_.target()->structure.robot : nullptr,
              .progress = [&](const EeaProgress& progress) { display.show(index, progress); },
              .evaluations = elsewhere ? &*elsewhere : nullptr},
             target.target(), state);
    store.end(RunEnding::done);
  } catch (const Interrupted& interruption) {
    end.ending = RunEnding::interrupted;
    end.problem = interruption.what();
  } catch (const std::exception& error) {
    fail(end, error);
  }
  close(store, end);
  end.storage_seconds = store.seconds();
  end.seconds = store.work_seconds();
  end.process_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  display.end_replicate(index, end);
}

/// There may be thousands.
void Replicates::end_those_without_a_turn(const std::vector<ReplicateEnd>& ends) {
  const std::lock_guard lock(writing_);
  Transaction transaction(database_);
  std::vector<RunId> runs;
  for (const ReplicateEnd& end : ends)
    if (!end.began && !is_taken_over(database_, end.planned.run) && !is_done(database_, end.planned.run))
      runs.push_back(end.planned.run);
  end_runs(database_, runs, RunEnding::interrupted);
  transaction.commit();
}

std::vector<ReplicateEnd> Replicates::run(const std::vector<PlannedReplicate>& planned, int threads,
                                          RunDisplay& display) {
  std::vector<ReplicateEnd> ends;
  ends.reserve(planned.size());
  for (const PlannedReplicate& each : planned) ends.emplace_back().planned = each;
  const int side_by_side = std::min({threads, static_cast<int>(planned.size()), most_side_by_side(opened_)});
  const ClaimBeats beats(database_, writing_);
  const int threads_each = std::max(1, threads / std::max(1, side_by_side));
  parallel_for(planned.size(), side_by_side,
               [&](std::size_t index, int) { carry_out(index, threads_each, display, ends[index]); });
  if (std::any_of(ends.begin(), ends.end(), [](const ReplicateEnd& end) { return !end.began; }))
    end_those_without_a_turn(ends);
  return ends;
}

}  // namespace lacuna
