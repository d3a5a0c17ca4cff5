#pragma once

#include <lacuna/target_system.h>

#include "evaluation/model/model_definition.h"
#include "foundation/processes/stop.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lacuna {

/// Duration of a test and times at which its sensors are read: 0, p, 2p ... up to the duration, p being the control
/// period.
std::vector<double> sample_times(const EngineSettings& engine, double duration);

/// Carries tests out on a robot with the hidden truth, with noise and quantisation. One thread at a time.
class TargetSimulator : public Simulator {
 public:
  /// `hidden`: one value per `definition.free`. Trials are reproducible from `noise_seed` and their numbers.
  /// `stop`: of the work that carries the tests out.
  TargetSimulator(const ModelDefinition& definition, std::vector<double> hidden, std::uint64_t noise_seed,
                  const Stop& stop = {});
  ~TargetSimulator() override;

  /// The next trial is the `number`th, which keys its noise.
  void begin_trial(std::uint64_t number) { number_ = number; }
  /// Throws `Error` where the target cannot carry the test out.
  Trial simulate(const Test& test) const override;

 private:
  struct Desk;
  std::unique_ptr<CompiledModel> model_;
  std::unique_ptr<Desk> simulator_;
  EngineSettings engine_;
  RobotSpec robot_;
  std::vector<double> hidden_;
  std::uint64_t noise_seed_;
  Stop stop_;
  std::uint64_t number_ = 0;
};

}  // namespace lacuna
