#pragma once

#include <lacuna/test.h>
#include <lacuna/test_encoding.h>

#include "evaluation/model/known_setups.h"
#include "config/schema/experiment.h"
#include "loading/plugin_catalog.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace lacuna {

/// A test as a user writes it.
struct AskedTest {
  std::string test;      ///< a line such as "triangle motor 0.3 N*m 0.1 Hz 20 s", or a CSV file of commands
  std::string duration;  ///< instead of the test's, a quantity; empty: the test's
  std::optional<std::string> setup = {};  ///< of the rig, by its name or "none"; nothing: the first recording's
};

/// Adds --test, --duration and --setup. `description`: of --test.
void add_test_options(CLI::App& command, AskedTest& asked, const std::string& description);

/// The duration that was asked for, s; nothing where the test's own counts. Throws `BadInput` where it is none.
std::optional<double> asked_duration(const AskedTest& asked);

/// The setup of the recordings that the test is asked for in. Throws `BadInput` for a name that none has, and where the
/// target is not recorded: nothing that Lacuna drives can be set up in another way.
KnownSetup asked_setup(const AskedTest& asked, const Experiment& experiment, const ModelDefinition& definition);

/// The series of commands that is meant. Of `space` its duration does not count. Throws `BadInput` with everything that
/// is wrong: actuators that are not there, commands beyond their limits, units, tests that are too short.
Test read_test(const AskedTest& asked, const TestSpace& space, const PluginCatalog& catalog);

}  // namespace lacuna
