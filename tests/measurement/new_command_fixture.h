#pragma once

#include "app/commands/commands.h"
#include "config/experiment_reader.h"
#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace lacuna {

/// A robot whose names no draft would choose.
inline constexpr const char* kPivot = R"([robot]
name = "pivot"
[body.rod]
mass = 0.5
com = [0.0, 0.0, -0.2]
inertia = [0.02, 0.02, 0.001]
[joint.pivot]
kind = "hinge"
child = "rod"
axis = "y"
[actuator.drive]
joint = "pivot"
kind = "force"
[sensor.encoder]
kind = "joint_position"
joint = "pivot"
[sensor.tacho]
kind = "joint_velocity"
joint = "pivot"
)";

/// `lacuna new` as a user types it, in a folder of its own.
class NewCommand : public testing::Test {
 protected:
  struct Outcome {
    int code = 0;
    std::string out, err;
  };

  Outcome run(std::vector<std::string> words) const {
    words.insert(words.begin(), "lacuna");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = run_program(static_cast<int>(arguments.size()), arguments.data());
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    return outcome;
  }

  Outcome run_new(const std::vector<std::filesystem::path>& files) const {
    std::vector<std::string> words{"new", rig().string(), "--from"};
    for (const std::filesystem::path& file : files) words.push_back(file.string());
    return run(words);
  }

  Outcome run_new_of(const std::filesystem::path& file, const std::string& robot) const {
    return run({"new", rig().string(), "--from", file.string(), "--robot", (folder_.path() / robot).string()});
  }

  std::filesystem::path rig() const { return folder_.path() / "rig.toml"; }
  std::filesystem::path robot() const { return folder_.path() / "rig-robot.toml"; }

  static std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  /// What a user would put into the blanks, by the unit they ask for.
  void fill(const std::filesystem::path& file) const {
    std::string text = text_of(file);
    const std::pair<const char*, const char*> kValues[] = {{R"("FILL IN kg")", R"("0.5 kg")"},
                                                           {R"("FILL IN m")", R"("-0.2 m")"},
                                                           {R"("FILL IN kg\*m\^2")", R"("0.02 kg*m^2")"},
                                                           {R"("FILL IN world or [a-z0-9_]+")", R"("world")"},
                                                           {R"x("FILL IN ([^"]+)")x", R"("35 $1")"}};
    for (const auto& [blank, value] : kValues) text = std::regex_replace(text, std::regex(blank), value);
    text = std::regex_replace(text, std::regex("(_motor|motor)( = .*)\"FILL IN\""), "$1$2\"N*m\"");
    text = std::regex_replace(text, std::regex("(_velocity|velocity)( = .*)\"FILL IN\""), "$1$2\"rad/s\"");
    text = std::regex_replace(text, std::regex("\"FILL IN\""), "\"rad\"");
    std::ofstream(file) << text;
  }

  /// The draft is refused at its blanks, and accepted with its recordings once they are filled.
  Recording expect_a_draft_that_works() const {
    EXPECT_THROW(read_experiment(rig()), BadInput);
    fill(rig());
    fill(robot());
    const Outcome checked =
        run({"check", rig().string(), "--plugin-path", LACUNA_BINARY_DIRECTORY "/lib/lacuna/plugins"});
    EXPECT_EQ(checked.code, 0) << checked.err;
    const Experiment experiment = read_experiment(rig());
    return read_recording(experiment.target.recording, experiment.model.declared.value());
  }

  TestFolder folder_;
};

}  // namespace lacuna
