#include "bench/bench_quadruped.h"

#include "loading/plugin_catalog.h"

#include <cmath>
#include <vector>

namespace lacuna {

RobotSpec bench_quadruped() {
  static const PluginCatalog catalog({LACUNA_PLUGINS_DIRECTORY});
  const RobotDefinition& definition = catalog.get<RobotDefinition>("quadruped");
  std::vector<double> defaults;
  for (const ParameterDeclaration& parameter : definition.parameters()) defaults.push_back(parameter.default_value);
  RobotSpec robot = definition.build({.parameters = defaults, .declared = nullptr});
  robot.contact.stiffness = 2e4;
  robot.contact.damping = 300.0;
  return robot;
}

double bench_command(std::size_t joint, double time) {
  return 0.8 * std::sin(6.0 * time + 0.8 * static_cast<double>(joint));
}

}  // namespace lacuna
