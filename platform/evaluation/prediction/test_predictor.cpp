#include "evaluation/prediction/test_predictor.h"

#include <lacuna/error.h>

#include <algorithm>
#include <utility>

namespace lacuna {

/// Workspace of one thread.
struct TestPredictor::Desk {
  CandidateSimulator candidate;
  SimulationOptions options = {};
  SimulationResult result = {};
};

TestPredictor::TestPredictor(const CompiledModel& model, std::vector<double> times, const Work& work,
                             const ModelDefinition* definition, std::size_t models, double start)
    : times_(std::move(times)) {
  for (int worker = 0; worker < std::max(work.threads, 1); ++worker) {
    auto simulator = std::make_unique<Desk>(Desk{CandidateSimulator(model, definition, models)});
    simulator->options.start_time = start;
    simulator->options.end_time = times_.back();
    simulator->options.output_times = times_;
    simulator->options.record_centre_of_mass = true;
    simulator->options.stop = work.stop;
    simulators_.push_back(std::move(simulator));
  }
}

TestPredictor::~TestPredictor() = default;

bool TestPredictor::predict(const ModelProposal& candidate, const Test& test, int worker, TestPrediction& prediction,
                            std::uint64_t& steps, std::string& reason) const {
  Desk& simulator = *simulators_[static_cast<std::size_t>(worker)];
  simulator.options.start = test.start;
  try {
    simulator.candidate.take(candidate);
  } catch (const Error& error) {
    reason = error.what();
    return false;
  }
  simulator.candidate.simulate(test, simulator.options, simulator.result);
  steps += simulator.result.steps;
  std::swap(prediction.sensors, simulator.result.readings);
  std::swap(prediction.centre_of_mass, simulator.result.centre_of_mass);
  if (simulator.result.ending == Ending::completed) return true;
  reason = simulator.result.reason;
  return false;
}

}  // namespace lacuna
