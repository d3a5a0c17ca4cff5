#include "app/workspace/experiment_workflow.h"
#include "bench/force_error.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

/// The force-level error of an experiment's model as `lacuna fit` leaves it, for a rig with one joint, its position
/// measured and its force commanded: beside figures from the literature, which are often told at this level. The fit is
/// the database's, where it has one.
///
///   bench_force_error EXPERIMENT.toml [CUTOFF_HZ [DATABASE]]
int main(int argc, char** argv) {
  using namespace lacuna;
  if (argc < 2) {
    fmt::print(stderr, "bench_force_error EXPERIMENT.toml [CUTOFF_HZ [DATABASE]]\n");
    return EXIT_FAILURE;
  }
  try {
    const double cutoff = argc > 2 ? std::atof(argv[2]) : 100.0;
    CommonOptions options;
    options.experiment = argv[1];
    if (argc > 3) options.database = argv[3];
    ExperimentWorkflow workflow(options);
    const std::vector<double> values = workflow.fit_model().result.parameters();
    const OpenExperiment& opened = workflow.opened();
    for (const Trial& trial : opened.trials) {
      const ForceError error = force_error(*opened.model, trial, values, cutoff);
      fmt::print("{} {}: {:.3g} rms, {:.2f} % of the command's, low-pass {:g} Hz\n",
                 trial.held_out ? "held out" : "fit     ", trial.name, error.rms, 100.0 * error.relative, cutoff);
    }
    workflow.recorder().done();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
