#pragma once

#include "eea/definition/evaluations.h"
#include "isolation/worker_pool.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

/// Simulates models in worker processes. A process that ends is replaced; the model or test that ended it becomes
/// invalid, with the cause as its reason, and the rest of its work goes to another process. Throws `Error` where a
/// component has ended three processes.
class RemoteEvaluations : public Evaluations {
 public:
  /// The pool must outlive it; works in `workers` processes.
  RemoteEvaluations(WorkerPool& pool, int workers);
  ~RemoteEvaluations() override;

  void begin_estimation(const EeaState& state) override;
  std::vector<ModelScore> score(std::span<const CandidateModel> candidates, std::optional<double> bar) override;
  std::uint64_t begin_exploration(const EeaState& state) override;
  std::vector<JudgedTest> judge(std::span<const Genome> tests) override;
  ModelScore score_on(const KnownModel& model, const TargetTrial& trial, int pass) override;
  PredictedTrial predict_trial(const KnownModel& model, const TargetTrial& trial) override;
  std::vector<ModelScore> find_delays(std::span<const KnownModel* const> models, const EeaState& state) override;

 private:
  struct Worker {
    std::unique_ptr<WorkerProcess> process;
    bool has_begun = false;  ///< the phase
  };

  void begin(Request phase);
  std::string ask(Worker& worker, const Request& request);
  std::string make_ready(Worker& worker);
  template <class Result, class MakeRequest>
  std::vector<Result> share_out(std::size_t count, const MakeRequest& request_for);
  template <class Result>
  Result ask_for_one(const Request& request);

  WorkerPool& pool_;
  std::vector<Worker> workers_;
  std::optional<Request> phase_;  ///< the message that begins the current phase
};

}  // namespace lacuna
