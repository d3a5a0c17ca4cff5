#include "evaluation/prediction/test_predictor.h"

#include <lacuna/error.h>

#include <algorithm>
#include <utility>

namespace lacuna {

/// Workspace of one thread.
struct TestPredictor::Desk {
  CandidateDesk candidate;
  SimulationOptions options = {};
  SimulationResult result = {};
};

TestPredictor::TestPredictor(const CompiledModel& model, std::vector<double> times, int workers,
                             const ModelDefinition* definition, std::size_t models, double start)
    : times_(std::move(times)) {
  for (int worker = 0; worker < std::max(workers, 1); ++worker) {
    auto desk = std::make_unique<Desk>(Desk{CandidateDesk(model, definition, models)});
    desk->options.start_time = start;
    desk->options.end_time = times_.back();
    desk->options.output_times = times_;
    desk->options.record_centre_of_mass = true;
    desks_.push_back(std::move(desk));
  }
}

TestPredictor::~TestPredictor() = default;

bool TestPredictor::predict(const ModelProposal& candidate, const Test& test, int worker, TestPrediction& prediction,
                            std::uint64_t& steps, std::string& reason) const {
  Desk& desk = *desks_[static_cast<std::size_t>(worker)];
  desk.options.start = test.start;
  try {
    desk.candidate.take(candidate);
  } catch (const Error& error) {
    reason = error.what();
    return false;
  }
  desk.candidate.simulate(test, desk.options, desk.result);
  steps += desk.result.steps;
  std::swap(prediction.sensors, desk.result.readings);
  std::swap(prediction.centre_of_mass, desk.result.centre_of_mass);
  if (desk.result.ending == Ending::completed) return true;
  reason = desk.result.reason;
  return false;
}

}  // namespace lacuna
