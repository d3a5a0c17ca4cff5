#include "bad_plugins/bad_folder.h"

#include <gmock/gmock.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <regex>

/// A plugin that fails while a command works: the command ends with a sentence, and the database holds what it
/// held before.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path kRig = std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests" / "bad_plugins" / "rig";

struct Outcome {
  int code = 0;
  std::string output;  ///< of both streams
};

Outcome lacuna(const std::string& arguments) {
  const std::string call = LACUNA_BINARY_DIRECTORY "/bin/lacuna " + arguments + " 2>&1";
  std::FILE* pipe = popen(call.c_str(), "r");
  Outcome outcome;
  std::array<char, 4096> block{};
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe))
    outcome.output.append(block.data(), got);
  outcome.code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

class BadPluginAndDatabase : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome first = compare("");
    ASSERT_EQ(first.code, 0) << first.output;
    before_ = history();
    ASSERT_THAT(before_, testing::EndsWith("rad"));
  }

  Outcome compare(const std::string& more) const { return lacuna("compare " + rig() + " --db " + db() + " " + more); }
  /// Compares with this effect, its plugin in `library`.
  Outcome compare_with(const std::string& library, const std::string& effect, const std::string& where) const {
    const BadFolder folder(library);
    return compare("--plugin-path " + folder.path().string() + " --set 'model.effects=[{effect=\"" + effect +
                   "\",where=\"" + where + "\"}]'");
  }
  /// What the database says of the sound model: its error in `lacuna history`.
  std::string history() const {
    const std::string output = lacuna("history " + rig() + " --db " + db()).output;
    std::smatch match;
    return std::regex_search(output, match, std::regex("rigid +([0-9.]+ .?.?rad)")) ? match[1].str() : output;
  }
  void expect_database_intact() const {
    EXPECT_THAT(lacuna("sql " + db() + " 'PRAGMA integrity_check'").output, HasSubstr("ok"));
    EXPECT_THAT(lacuna("sql " + db() + " 'PRAGMA foreign_key_check'").output, testing::Not(HasSubstr("revision")));
    EXPECT_EQ(history(), before_);
    const Outcome again = compare("");
    EXPECT_EQ(again.code, 0) << again.output;
  }
  std::string rig() const { return (kRig / "rig.toml").string(); }
  std::string db() const { return (folder_.path() / "wheel.db").string(); }

  TestFolder folder_;
  std::string before_;
};

TEST_F(BadPluginAndDatabase, AForeignExceptionInTheMiddleOfAFit) {
  const Outcome outcome = compare_with("throwing", "throws_in_step", "joint.axle");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("effect \"throws_in_step\""), HasSubstr("throwing.so"),
                                    HasSubstr("rig::Trouble"), HasSubstr("repair it")));
  expect_database_intact();
}

TEST_F(BadPluginAndDatabase, NotANumberInTheMiddleOfAFit) {
  for (const auto& [effect, where] : {std::pair{"nan_load", "joint.axle"}, std::pair{"nan_command", "actuator.motor"},
                                      std::pair{"nan_reading", "sensor.angle"}}) {
    const Outcome outcome = compare_with("not_a_number", effect, where);
    EXPECT_EQ(outcome.code, 1) << effect;
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr(effect), HasSubstr("not_a_number.so"), HasSubstr("take the effect out of the model")));
  }
  expect_database_intact();
}

TEST_F(BadPluginAndDatabase, AComponentThatCannotBeMadeIsBadInput) {
  const Outcome outcome = compare_with("throwing", "throws_in_factory", "joint.axle");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("model.effects[0].effect"), HasSubstr("throwing.so"), HasSubstr("no licence found")));
  expect_database_intact();
}

TEST_F(BadPluginAndDatabase, AStateOfTheWrongSize) {
  const Outcome outcome = compare_with("wrong_size", "negative_state", "joint.axle");
  EXPECT_NE(outcome.code, 0);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("negative_state"), HasSubstr("wrong_size.so")));
  expect_database_intact();
}

TEST_F(BadPluginAndDatabase, ABrokenFileBesideTheSoundOnesDoesNotMatter) {
  const BadFolder folder("dies_on_load");
  const Outcome outcome = compare("--plugin-path " + folder.path().string());
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  expect_database_intact();
}

}  // namespace
}  // namespace lacuna
