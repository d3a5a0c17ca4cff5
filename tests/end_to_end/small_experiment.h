#pragma once

namespace lacuna {

/// A quadruped on soft ground, tests of a second, two passes: a second or two on one thread.
inline constexpr const char* kSmallRun = R"(
[experiment]
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
duration = 1.0

[estimation]
parameters = { population = 40, keep = 20, generations = 8 }
objective = "parameter_error"

[exploration]
parameters = { population = 10, keep = 5, generations = 5 }
)";

}  // namespace lacuna
