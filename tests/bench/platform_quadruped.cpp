#include "bench/platform_quadruped.h"

#include "bench/bench_quadruped.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

class Walk : public Controller {
 public:
  void act(double time, std::span<const double>, std::span<double>, std::span<double> commands) const override {
    for (std::size_t i = 0; i < commands.size(); ++i) commands[i] = bench_command(i, time);
  }
};

}  // namespace

PlatformQuadruped::PlatformQuadruped() {
  ModelStructure structure;
  structure.robot = bench_quadruped();
  EngineSettings settings;
  settings.step = kBenchStep;
  model_ = compile(structure, settings);
  workspace_ = model_->make_workspace();
  test_.drive = std::make_shared<const Walk>();
}

void PlatformQuadruped::run(int steps) {
  times_.resize(static_cast<std::size_t>(steps) + 1);
  for (std::size_t i = 0; i < times_.size(); ++i) times_[i] = static_cast<double>(i) * kBenchStep;
  SimulationOptions options;
  options.end_time = times_.back();
  options.output_times = times_;
  model_->simulate({}, test_, options, *workspace_, result_);
  if (result_.ending != Ending::completed) throw Error("the quadruped's trial did not complete: " + result_.reason);
}

}  // namespace lacuna
