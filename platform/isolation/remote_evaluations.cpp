#include "isolation/remote_evaluations.h"

#include "foundation/parallel.h"
#include "isolation/carried.h"
#include "isolation/work_queue.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lacuna {
namespace {

void refuse(ModelScore& score, const std::string& reason) {
  score = {
      .total = std::numeric_limits<double>::infinity(), .trials = {}, .kind = ScoreKind::invalid, .reason = reason};
}

void refuse(PredictedTrial& predicted, const std::string&) { predicted = {}; }

void refuse(JudgedTest& judged, const std::string& reason) { judged = {kNotKnown, reason, 0}; }

}  // namespace

RemoteEvaluations::RemoteEvaluations(WorkerPool& pool, int workers)
    : pool_(pool), workers_(static_cast<std::size_t>(std::max(workers, 1))) {
  for (Worker& worker : workers_) worker.process = pool_.take();  // all start up at the same time
}

RemoteEvaluations::~RemoteEvaluations() {
  for (Worker& worker : workers_)
    if (worker.process) pool_.give_back(std::move(worker.process));
}

void RemoteEvaluations::begin(Request phase) {
  phase_ = std::move(phase);
  for (Worker& worker : workers_) worker.has_begun = false;
}

/// The worker's answer to the beginning of the phase; nothing where it has already begun it.
std::string RemoteEvaluations::make_ready(Worker& worker) {
  for (;;) {
    if (!worker.process) worker.process = pool_.take();
    if (!phase_ || worker.has_begun) return {};
    try {
      std::string answer = ask(worker, *phase_);
      worker.has_begun = true;
      return answer;
    } catch (const WorkerLost&) {  // the third loss of a worker throws another exception
      continue;
    }
  }
}

std::string RemoteEvaluations::ask(Worker& worker, const Request& request) {
  try {
    return worker.process->ask(request);
  } catch (const WorkerLost& lost) {
    worker = {};
    pool_.stop().throw_if_requested();  // the request that ended this process may have ended the other as well
    pool_.note_lost(lost.work);
    throw;
  } catch (...) {  // it may still be answering, or have ended
    worker = {};
    throw;
  }
}

/// `request_for` makes the request for the pieces with these indices; the answer has one result for each.
template <class Result, class MakeRequest>
std::vector<Result> RemoteEvaluations::share_out(std::size_t count, const MakeRequest& request_for) {
  std::vector<Result> results(count);
  WorkQueue queue(count, workers_.size());
  const auto work_off = [&](Worker& worker) {
    for (std::vector<std::size_t> part = queue.take(); !part.empty(); part = queue.take()) {
      make_ready(worker);
      try {
        auto answered = from_bytes<std::vector<Result>>(ask(worker, request_for(part)));
        if (answered.size() != part.size())
          throw Error("a worker process returned a wrong number of results; please report this with the command");
        for (std::size_t i = 0; i < part.size(); ++i) results[part[i]] = std::move(answered[i]);
      } catch (const WorkerLost& lost) {
        if (lost.work.is_the_tasks && lost.work.task < part.size()) {
          const auto culprit = part.begin() + lost.work.task;
          refuse(results[*culprit], lost.work.deed);
          part.erase(culprit);
        }
        queue.put_back(part);
      }
    }
  };
  parallel_for(workers_.size(), static_cast<int>(workers_.size()), [&](std::size_t i, int) {
    try {
      work_off(workers_[i]);
    } catch (...) {
      queue.close();
      throw;
    }
  });
  return results;
}

/// Between two phases.
template <class Result>
Result RemoteEvaluations::ask_for_one(const Request& request) {
  phase_.reset();
  return share_out<Result>(1, [&](const std::vector<std::size_t>&) { return request; }).front();
}

void RemoteEvaluations::begin_estimation(const EeaState& state) { begin(BeginEstimation{wired(state)}); }

std::vector<ModelScore> RemoteEvaluations::score(std::span<const CandidateModel> candidates,
                                                 std::optional<double> bar) {
  return share_out<ModelScore>(candidates.size(), [&](const std::vector<std::size_t>& part) {
    ScoreModelsRequest request{{}, bar};
    for (const std::size_t i : part) request.models.push_back(*candidates[i].genome);
    return Request(std::move(request));
  });
}

std::uint64_t RemoteEvaluations::begin_exploration(const EeaState& state) {
  begin(BeginExploration{wired(state)});
  return from_bytes<std::uint64_t>(make_ready(workers_.front()));
}

std::vector<JudgedTest> RemoteEvaluations::judge(std::span<const Genome> tests) {
  return share_out<JudgedTest>(tests.size(), [&](const std::vector<std::size_t>& part) {
    JudgeTests request;
    for (const std::size_t i : part) request.tests.push_back(tests[i]);
    return Request(std::move(request));
  });
}

ModelScore RemoteEvaluations::score_on(const KnownModel& model, const TargetTrial& trial, int pass) {
  return ask_for_one<ModelScore>(ScoreOn{wired(model), wired(trial), pass});
}

PredictedTrial RemoteEvaluations::predict_trial(const KnownModel& model, const TargetTrial& trial) {
  return ask_for_one<PredictedTrial>(PredictTrial{wired(model), wired(trial)});
}

std::vector<ModelScore> RemoteEvaluations::find_delays(std::span<const KnownModel* const> models,
                                                       const EeaState& state) {
  phase_.reset();
  return share_out<ModelScore>(models.size(), [&](const std::vector<std::size_t>& part) {
    FindDelays request{{}, wired(state)};
    for (const std::size_t i : part) request.models.push_back(wired(*models[i]));
    return Request(std::move(request));
  });
}

}  // namespace lacuna
