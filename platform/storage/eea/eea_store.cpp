#include "storage/eea/eea_store.h"

#include "foundation/digest.h"
#include "storage/core/number_blob.h"
#include "storage/core/run_claim.h"
#include "storage/core/storage_error.h"
#include "storage/eea/eea_writer.h"

#include <lacuna/error.h>

#include <algorithm>

namespace lacuna {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string digest_of(const CheckpointRow& checkpoint) {
  const std::span<const std::byte> bytes = number_bytes(checkpoint.state);
  return sha256({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

template <class Row>
void sort_by_number(std::vector<Row>& rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.number < b.number; });
}

}  // namespace

/// What the next commit writes.
struct EeaStore::Pending {
  struct Prediction {
    std::uint64_t model = 0;
    int trial = 0;
    TimeSeries readings;
    TimeSeries centre_of_mass;
  };
  std::vector<TestRow> tests;
  std::vector<std::pair<TargetTrialRow, Trial>> trials;
  std::vector<ModelRow> models;
  std::vector<Prediction> predictions;
  std::vector<PassRow> passes;

  bool empty() const {
    return tests.empty() && trials.empty() && models.empty() && predictions.empty() && passes.empty();
  }
};

EeaStore::EeaStore(Database& database, std::mutex& writing, RunId run, ExperimentId experiment)
    : database_(database),
      writing_(writing),
      run_(run),
      experiment_(experiment),
      pending_(std::make_unique<Pending>()),
      made_(std::chrono::steady_clock::now()) {}

EeaStore::~EeaStore() {
  const std::lock_guard lock(writing_);
  writer_.reset();
  if (!to_end_) return;
  try {
    if (!is_taken_over()) end_run_unless_ended(database_, run_, RunEnding::failed);
  } catch (const std::exception&) {
    // Whatever ended the run has been reported; a run without an ending reads as "not ended".
  }
}

void EeaStore::append(ModelRow row) { pending_->models.push_back(std::move(row)); }
void EeaStore::append(TestRow row) { pending_->tests.push_back(std::move(row)); }
void EeaStore::append(PassRow row) { pending_->passes.push_back(std::move(row)); }

void EeaStore::append(TargetTrialRow row, const Trial& trial) { pending_->trials.emplace_back(std::move(row), trial); }

void EeaStore::append_prediction(std::uint64_t model, int trial, const TimeSeries& readings,
                                 const TimeSeries& centre_of_mass) {
  pending_->predictions.push_back({model, trial, readings, centre_of_mass});
}

void EeaStore::commit(const CheckpointRow& checkpoint) {
  const auto begin = std::chrono::steady_clock::now();
  sort_by_number(pending_->tests);
  sort_by_number(pending_->models);
  {
    const std::lock_guard lock(writing_);
    const std::optional<std::int64_t> commits = commits_;
    try {
      write(checkpoint);
    } catch (...) {
      writer_.reset();
      commits_ = commits;
      throw;
    }
  }
  *pending_ = {};
  to_end_ = true;
  seconds_ += seconds_since(begin);
}

void EeaStore::note_failure(const FailedTrialRecord& failed) {
  const std::lock_guard lock(writing_);
  Transaction transaction(database_);
  record_failed_trial(database_, run_, experiment_, failed);
  transaction.commit();
}

void EeaStore::write(const CheckpointRow& checkpoint) {
  Transaction transaction(database_);
  if (!writer_) {
    writer_ = std::make_unique<EeaWriter>(database_, run_, experiment_);
    set_run_ending(database_, run_, std::nullopt);
  }
  write_checkpoint(checkpoint);
  for (const TestRow& test : pending_->tests) writer_->insert(test);
  for (const auto& [row, trial] : pending_->trials) writer_->insert(row, trial);
  for (const ModelRow& model : pending_->models) writer_->insert(model);
  for (const Pending::Prediction& prediction : pending_->predictions) {
    writer_->insert_prediction(prediction.model, prediction.trial, TraceKind::predicted, prediction.readings);
    if (!prediction.centre_of_mass.channels.empty()) {
      writer_->insert_prediction(prediction.model, prediction.trial, TraceKind::centre_of_mass,
                                 prediction.centre_of_mass);
    }
  }
  for (const PassRow& pass : pending_->passes) writer_->insert(pass);
  transaction.commit();
}

void EeaStore::write_checkpoint(const CheckpointRow& checkpoint) {
  Statement found(database_, "SELECT commits, seconds FROM checkpoint WHERE run = ?");
  const bool there = found.with(run_).step();
  const std::int64_t commits = there ? found.integer(0) : 0;
  if (!earlier_seconds_) earlier_seconds_ = there ? found.real(1) : 0.0;
  // Rows of two writers would contradict each other.
  check_claim(database_, run_);
  if (commits_ && *commits_ != commits) {
    throw Error(database_.file().string() + ": run " + std::to_string(run_.value) +
                " is also continued by another process; this process stops, and nothing stored is lost");
  }
  commits_ = commits + 1;
  Statement(database_,
            "INSERT INTO checkpoint (run, commits, seconds, state, digest) VALUES (?, ?, ?, ?, ?) ON CONFLICT (run)"
            " DO UPDATE SET commits = excluded.commits, seconds = excluded.seconds, state = excluded.state,"
            " digest = excluded.digest")
      .run_with(run_, *commits_, work_seconds(), number_bytes(checkpoint.state), digest_of(checkpoint));
}

void EeaStore::end(RunEnding ending) {
  if (ending == RunEnding::done && !pending_->empty()) {
    throw Error("EeaStore: what was appended has to be committed before the run ends");
  }
  *pending_ = {};
  const std::lock_guard lock(writing_);
  if (!is_taken_over()) set_run_ending(database_, run_, ending);
  to_end_ = false;
}

/// Whether another process has gone on with the run, whose ending is no more this one's.
bool EeaStore::is_taken_over() const {
  Statement row(database_, "SELECT commits FROM checkpoint WHERE run = ?");
  return commits_ && row.with(run_).step() && row.integer(0) != *commits_;
}

std::optional<CheckpointRow> EeaStore::checkpoint() const {
  const std::lock_guard lock(writing_);
  Statement row(database_, "SELECT state, digest, commits, seconds FROM checkpoint WHERE run = ?");
  const bool there = row.with(run_).step();
  commits_ = there ? row.integer(2) : 0;
  if (!earlier_seconds_) earlier_seconds_ = there ? row.real(3) : 0.0;
  if (!there) return std::nullopt;
  CheckpointRow checkpoint{numbers_in(row.bytes(0))};
  if (digest_of(checkpoint) != row.text(1)) {
    throw DamagedDatabase(database_.file().string() + ": the checkpoint of run " + std::to_string(run_.value) +
                          " is damaged: it does not match its digest; run again without --resume");
  }
  return checkpoint;
}

double EeaStore::seconds() const { return seconds_; }

double EeaStore::work_seconds() const { return earlier_seconds_.value_or(0.0) + seconds_since(made_); }

}  // namespace lacuna
