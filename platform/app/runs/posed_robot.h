#pragma once

#include <lacuna/test.h>

#include "simulation/compiled_model.h"

#include <memory>
#include <span>
#include <vector>

namespace lacuna {

/// A robot whose bodies are watched while it carries tests out: a model's own with an onlooker at each body.
class PosedRobot {
 public:
  PosedRobot(const ModelStructure& structure, const EngineSettings& engine, const Stop& stop = {});

  struct Motion {
    TimeSeries poses;     ///< channels as `ReplayRecord` says
    TimeSeries contacts;  ///< likewise; without channels where there is no ground
    TimeSeries readings;  ///< of the robot's own sensors
  };
  /// Reads at `times` (s, ascending). Throws `Error` with the reason where the robot cannot carry the test out.
  Motion move(std::span<const double> values, const Test& test, const std::vector<double>& times) const;

 private:
  std::vector<Channel> poses_, contacts_;
  std::unique_ptr<CompiledModel> model_;
  Stop stop_;
};

}  // namespace lacuna
