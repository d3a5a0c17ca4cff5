#include "config/experiment_reader.h"
#include "where_it_fails/where_it_fails.h"
#include "fitting/fit.h"
#include "foundation/address.h"
#include "measurement/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace lacuna {
namespace {

// The rig of experiments/real/emps.toml with a mass alone; published are viscous and Coulomb friction (Janot, Gautier
// and Brunot, 2019). Its recordings are not part of the project.
TEST(WhereItFails, EmpsFromItsMassAloneDependsOnVelocityAndDirectionOfMotion) {
  if (!std::getenv("LACUNA_DATA")) GTEST_SKIP() << "LACUNA_DATA is not set";
  Experiment experiment = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/real/emps.toml");
  experiment.fit.method = "free_run";
  experiment.fit.starts = 1;
  const ModelDefinition definition = define_model(experiment, PluginCatalog(plugin_search_path({})));
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const RobotSpec& robot = definition.structure.robot;
  std::vector<Trial> trials =
      read_recording(experiment.target.recording, sensor_channels(robot), command_channels(robot)).trials;
  std::erase_if(trials, [](const Trial& trial) { return trial.held_out; });
  const std::vector<double> values = fit({definition, *model, trials, experiment.fit, 1, {2}}).parameters();
  const Comparison comparison =
      compare({definition, *model, trials, experiment.noise, values, nullptr, {0.1, 0.5}, 1, {2}});
  const WhereItFails where = where_it_fails({definition, *model, trials, values, comparison, {2}});
  const auto found = std::find_if(where.findings.begin(), where.findings.end(), [](const Finding& finding) {
    return finding.kind == FindingKind::dependence && finding.view == ViewKind::acceleration;
  });
  ASSERT_NE(found, where.findings.end());
  const auto names = [&](FeatureKind kind) {
    return std::any_of(found->features.begin(), found->features.end(),
                       [&](std::size_t feature) { return where.table.features[feature].kind == kind; });
  };
  EXPECT_TRUE(names(FeatureKind::velocity));
  EXPECT_TRUE(names(FeatureKind::direction));
  EXPECT_FALSE(names(FeatureKind::time));
  EXPECT_GT(found->share, 0.5);
}

}  // namespace
}  // namespace lacuna
