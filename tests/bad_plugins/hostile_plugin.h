#pragma once

#include "bad_plugins/bad_folder.h"
#include "end_to_end/program.h"
#include "support/small_experiment.h"

#include <gmock/gmock.h>

#include <string>

namespace lacuna {

/// The program at work with the hostile plugin on its path.
class HostilePlugin : public testing::Test {
 protected:
  HostilePlugin() {
    const std::filesystem::path rig = std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests" / "bad_plugins" / "rig";
    for (const char* file : {"rig.toml", "robot.toml", "spin.csv"}) program_.write(file, read_bytes(rig / file));
    program_.write("small.toml", small_experiment("0.2", "population = 4, keep = 2, generations = 2",
                                                  "population = 4, keep = 2, generations = 2"));
  }
  /// What the hostile plugin does is told it by `order` (hostile.cpp).
  Outcome lacuna(const std::string& order, const std::string& command) const {
    return program_.shell("export HOSTILE='" + order + "'; lacuna " + command + " --plugin-path " +
                          folder_.path().string());
  }
  /// The same of a plugin that waits until it is used in earnest.
  Outcome lacuna_later(const std::string& order, const std::string& command) const {
    return program_.shell("export HOSTILE_LATER=1 HOSTILE='" + order + "'; lacuna " + command + " --plugin-path " +
                          folder_.path().string());
  }
  static std::string compare(const std::string& effect) {
    return "compare rig.toml --set 'model.effects=[{effect=\"" + effect + "\",where=\"joint.axle\"}]'";
  }
  std::string file() const { return (folder_.path() / "hostile.so").string(); }
  auto names(const std::string& component, const std::string& what) const {
    return testing::AllOf(testing::HasSubstr(component + " (" + file() + "): " + what),
                          testing::HasSubstr("this is a fault of the plugin"));
  }

  BadFolder folder_{"hostile"};
  Program program_;
};

}  // namespace lacuna
