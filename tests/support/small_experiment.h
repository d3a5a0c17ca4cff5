#pragma once

#include <string>

namespace lacuna {

/// A quadruped on soft ground with nine hidden masses and eight hidden lags, two passes of the algorithm. `duration` of
/// a test in s; `estimation` and `exploration` are the searches' parameters, as in "population = 12, keep = 6".
inline std::string small_experiment(const std::string& duration, const std::string& estimation,
                                    const std::string& exploration) {
  return R"([experiment]
name = "small"
passes = 2

[target]
kind = "simulated"
robot = "quadruped"
hidden = { "body.*.mass" = { uniform = [1.0, 7.0] }, "sensor.*.delay" = { uniform = [0.0, 0.2] } }

[model]
robot = "quadruped"
free = { "body.*.mass" = [1.0, 7.0], "sensor.*.delay" = [0.0, 0.2] }

[engine]
step = 0.01
delay_rounding = "step"
contact = { stiffness = 2e4, damping = 300.0 }

[test]
duration = )" +
         duration + R"(

[estimation]
objective = "parameter_error"
parameters = { )" +
         estimation + R"( }

[exploration]
parameters = { )" +
         exploration + " }\n";
}

}  // namespace lacuna
