#pragma once

#include <string>

namespace lacuna {

/// The shape of five cylinders from their ranges to four beacons, two passes of the algorithm with a dozen models.
inline const std::string kSmallShape = R"([experiment]
name = "small_shape"
passes = 2

[target]
kind = "simulated"
robot = "five_cylinders"
parameters = { beacons = 4 }

[model]
robot = "five_cylinders"
parameters = { beacons = 4 }
encoding = "morphology"

[engine]
step = 0.01

[test]
sensors = ["sensor.touch*", "sensor.angle*"]
duration = 0.2

[estimation]
sensors = ["sensor.range*"]
objective = "part_distance"
search = "paired_tournament"
parameters = { population = 12, pairs = 9, generations = 4 }
mutation = [ { operator = "reset_or_nudge" } ]
seeds = 1

[exploration]
fitness = "random"
)";

}  // namespace lacuna
