#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

/// A command line that cannot be, and what is said of it.
struct BadInputCase {
  const char* name;
  const char* arguments;
  int exit_code;
  const char* sentence;  ///< a part of it
};

void PrintTo(const BadInputCase& bad, std::ostream* out) { *out << bad.arguments; }

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// The servo pendulum among files of all wrong kinds.
class BadInputTest : public testing::TestWithParam<BadInputCase> {
 protected:
  void SetUp() override {
    program_.copy_first_steps();
    program_.copy_smoke();
    program_.write("binary.toml", std::string("\x7f\x45\x4c\x46\x00\xff\xfe", 7));
    program_.write("empty.toml", "");
    program_.write("empty.csv", "");
    program_.write("one.csv", "t_s,angle_deg,torque_Nm\n0,1,2\n0.1,2,3\n0.2,1,2\n");
    program_.write("shopping.db", "This was a shopping list and is kept.\n");
    fs::create_directory(program_.folder() / "folder");
    fs::create_symlink("circle.json", program_.folder() / "circle.json");
  }
  Program program_;
};

TEST_P(BadInputTest, IsSaidInOneVoiceAndChangesNothing) {
  const std::string as_written = program_.read("first-steps.toml");
  const Outcome outcome = program_.run(words_of(GetParam().arguments));
  EXPECT_EQ(outcome.exit_code, GetParam().exit_code) << outcome.output << outcome.errors;
  EXPECT_THAT(outcome.errors, HasSubstr(GetParam().sentence));
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(program_.read("first-steps.toml"), as_written);
  EXPECT_EQ(program_.read("shopping.db"), "This was a shopping list and is kept.\n");
  EXPECT_FALSE(fs::exists(program_.folder() / "not")) << "a folder for results that there are none of";
  EXPECT_FALSE(fs::exists(program_.folder() / "first-steps.db")) << "it was refused before the database was made";
}

const std::string kLongName(300, 'x'), kLongJson = "compare first-steps.toml --json=" + kLongName,
                                       kLongOut = "compare first-steps.toml --out not/" + kLongName + "/there";

constexpr const char* kAdd = "add first-steps.toml coulomb_friction --where joint.hinge";
const std::string kAddWith = std::string(kAdd) + " ";
const std::string kBadId = kAddWith + "--id a.b", kBadStart = kAddWith + "--start torque",
                  kWordStart = kAddWith + "--start torque=much", kNoStart = kAddWith + "--start torque=nan",
                  kLowStart = kAddWith + "--start torque=-1", kOtherStart = kAddWith + "--start torqe=1",
                  kOtherFixed = kAddWith + "--fixed torqe";

INSTANTIATE_TEST_SUITE_P(
    CommandLines, BadInputTest,
    testing::Values(
        BadInputCase{"NoCommand", "", 2,
                     "lacuna: name a command: check, new, trial, run, runs, predict, plot, curves,"},
        BadInputCase{"UnknownCommand", "histroy", 2,
                     "lacuna: there is no command \"histroy\" (did you mean \"history\"?)"},
        BadInputCase{
            "UnknownSubcommand", "plugins lits", 2,
            "lacuna plugins: there is no command \"lits\" (did you mean \"list\"?); see lacuna plugins --help"},
        BadInputCase{"HelpOfAnUnknownCommand", "help diagnos", 2,
                     "lacuna: there is no command \"diagnos\" (did you mean \"diagnose\"?); see lacuna --help"},
        BadInputCase{"UnknownOptionOfTheProgram", "--verison", 2,
                     "lacuna: there is no option --verison (did you mean \"--version\"?); see lacuna --help"},
        BadInputCase{"NoExperiment", "compare", 2, "lacuna compare: experiment is required; see lacuna compare --help"},
        BadInputCase{
            "UnknownOption", "compare first-steps.toml --thread 3", 2,
            "lacuna compare: there is no option --thread (did you mean \"--threads\"?); see lacuna compare --help"},
        BadInputCase{"OneArgumentTooMany", "compare first-steps.toml other.toml", 2,
                     "lacuna compare: one argument too many: other.toml; see lacuna compare --help"},
        BadInputCase{"NoThreads", "compare first-steps.toml --threads 0", 2,
                     "--threads: must be a whole number from 1 to 1024, but is \"0\""},
        BadInputCase{"LessThanNoThreads", "fit first-steps.toml --threads -1", 2, "but is \"-1\""},
        BadInputCase{"SeedOfLetters", "compare first-steps.toml --seed abc", 2,
                     "--seed: must be a whole number from 0 to 18446744073709551615, but is \"abc\""},
        BadInputCase{"SeedBelowZero", "compare first-steps.toml --seed -3", 2, "but is \"-3\""},
        BadInputCase{"PluginsNowhere", "check first-steps.toml --plugin-path nowhere", 2,
                     "--plugin-path: there is no folder nowhere"},
        BadInputCase{"SetWithATypo", "check first-steps.toml --set engine.stpe=0.001", 2,
                     "--set engine.stpe=0.001: engine: unknown key \"stpe\" (did you mean \"step\"?)"},
        BadInputCase{"StepsThatNobodyCanWaitFor", "compare first-steps.toml --set engine.step=1e-9", 2,
                     "--set engine.step=1e-9: engine.step: 1.00 ns makes"},
        BadInputCase{"DelaysThatNoMemoryHolds",
                     "compare first-steps.toml --set engine.step=1e-9 --set "
                     "model.effects=[{effect=\"command_delay\",where=\"actuator.motor\"}]",
                     2, "integration steps"},
        BadInputCase{"HistoryOfSuchSteps", "history first-steps.toml --set engine.step=1e-9", 2, "integration steps"},
        BadInputCase{"FileValueBeyondItsBounds",
                     "compare first-steps.toml --set model.free={\"body.arm.mass\"=[0.1,0.2]}", 2,
                     "body.arm.mass: 0.500000 kg lies outside 0.100000 kg to 0.200000 kg"},
        BadInputCase{"SetWithoutAValue", "check first-steps.toml --set engine.step", 2, "write KEY=VALUE"},
        BadInputCase{"JsonAndCsvTogether", "compare first-steps.toml --json --csv", 2,
                     "--json and --csv cannot both go to standard output"},
        BadInputCase{"SetTakesOneValueOnly", "check --set engine.step=0.001 first-steps.toml other.toml", 2,
                     "one argument too many: other.toml"},
        BadInputCase{"StatementMissing", "sql shopping.db", 2, "a statement in quotes, or --views"}),
    [](const auto& bad) { return bad.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Files, BadInputTest,
    testing::Values(
        BadInputCase{"ExperimentNowhere", "compare nowhere.toml", 2, "nowhere.toml: no such file"},
        BadInputCase{"ExperimentIsAFolder", "compare folder", 2, "folder: is a folder; name a file in it"},
        BadInputCase{"ExperimentIsBinary", "compare binary.toml", 2, "binary.toml:1:5: not TOML"},
        BadInputCase{"ExperimentIsEmpty", "compare empty.toml", 2, "empty.toml:1:1: experiment: is missing"},
        BadInputCase{"RecordingIsEmpty", "check first-steps.toml --set target.files=[\"empty.csv\"]", 2,
                     "empty.csv: is empty; it needs a header line"},
        BadInputCase{"RecordingIsAFolder", "check first-steps.toml --set target.files=[\"folder\"]", 2, "folder"},
        BadInputCase{"NewFromAnEmptyFile", "new rig.toml --from empty.csv", 2, "empty.csv: is empty"},
        BadInputCase{"NewFromNowhere", "new rig.toml --from nowhere.csv", 2, "nowhere.csv: there is no such file"},
        BadInputCase{"NewFromAFolder", "new rig.toml --from folder", 2, "folder: is a folder; name the files in it"},
        BadInputCase{"NewFromABinaryFile", "new rig.toml --from binary.toml", 2, "is a binary file, not CSV"},
        BadInputCase{"NewIntoNowhere", "new nowhere/rig.toml --from one.csv", 2,
                     "nowhere/rig.toml: cannot be written: there is no folder nowhere"},
        BadInputCase{"NewWithAnotherTime", "new rig.toml --from one.csv --time ts", 2,
                     "one.csv:1: no column `ts` (did you mean \"t_s\"?)"},
        BadInputCase{"NewOfARobotNowhere", "new rig.toml --from one.csv --robot nowhere.toml", 2,
                     "nowhere.toml: no such file"},
        BadInputCase{"PicturesIntoAFile", "compare first-steps.toml --out one.csv", 2,
                     "one.csv: cannot be a folder for results"},
        BadInputCase{"PicturesBelowAFile", "compare first-steps.toml --out one.csv/pictures", 2,
                     "one.csv/pictures: cannot be a folder for results"},
        BadInputCase{"PicturesOfNothing", "compare nowhere.toml --out not/made", 2, "nowhere.toml: "},
        BadInputCase{"PicturesOfABadValue", "compare first-steps.toml --set engine.step=-1 --out not/made", 2,
                     "engine"},
        BadInputCase{"PicturesOfNoDiagnosis", "diagnose nowhere.toml --out not/made", 2, "nowhere.toml: "},
        BadInputCase{"PicturesOfNoHistory", "history nowhere.toml --out not/made", 2, "nowhere.toml: "},
        BadInputCase{"JsonIntoNowhere", "compare first-steps.toml --json=nowhere/result.json", 2,
                     "nowhere/result.json: cannot be written: there is no folder nowhere"},
        BadInputCase{"JsonIntoACircleOfLinks", "compare first-steps.toml --json=circle.json", 2,
                     "circle.json: cannot be written: its symbolic links form a circle"},
        BadInputCase{"JsonOfALongName", kLongJson.c_str(), 2, "cannot be written: File name too long"},
        BadInputCase{"CsvIntoProc", "compare first-steps.toml --csv=/proc/x", 2, "/proc/x: cannot be written: folder"},
        BadInputCase{"PicturesIntoProc", "compare first-steps.toml --out=/proc/x", 2,
                     "/proc/x: cannot be written into: folder /proc cannot be written to"},
        BadInputCase{"PicturesIntoALongName", kLongOut.c_str(), 2,
                     "cannot be a folder for results: File name too long"},
        BadInputCase{"CsvIntoAFolder", "history first-steps.toml --csv=folder", 2, "folder: is a folder; name a file"},
        BadInputCase{"DatabaseIsNone", "compare first-steps.toml --db shopping.db", 2,
                     "shopping.db: is not a Lacuna database; name another file, or move this one away"},
        BadInputCase{"DatabaseIsAnAddress", "compare first-steps.toml --db file:u.db", 2,
                     "file:u.db: SQLite does not accept this as a file name; write ./file:u.db"},
        BadInputCase{"DatabaseInMemory", "compare first-steps.toml --db :memory:", 2, "write ./:memory:"},
        BadInputCase{"DatabaseIsACircle", "compare first-steps.toml --db circle.json", 2,
                     "circle.json: its symbolic links form a circle"},
        BadInputCase{"DatabaseToListIsACircle", "runs circle.json", 2, "circle.json: its symbolic links form a circle"},
        BadInputCase{"DatabaseIsAFolder", "compare first-steps.toml --db folder", 2, "folder: is a folder"},
        BadInputCase{"DatabaseIntoNowhere", "compare first-steps.toml --db nowhere/x.db", 2,
                     "nowhere/x.db: cannot be opened: there is no folder nowhere"},
        BadInputCase{"QueryOfNothing", "sql nowhere.db .", 2, "nowhere.db: no such database"},
        BadInputCase{"QueryOfAShoppingList", "sql shopping.db .", 2, "shopping.db: is not a Lacuna database"}),
    [](const auto& bad) { return bad.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Effects, BadInputTest,
    testing::Values(
        BadInputCase{"UnknownEffect", "add first-steps.toml coulomb --where joint.hinge", 2,
                     "there is no effect \"coulomb\" (did you mean \"coulomb_friction\"?)"},
        BadInputCase{"ARobotIsNoEffect", "add first-steps.toml declared --where joint.hinge", 2,
                     "there is no effect \"declared\""},
        BadInputCase{"NothingIsNearOfMany", "add first-steps.toml declared --where joint.hinge", 2,
                     "more; lacuna plugins list --kind effect lists all; searched in"},
        BadInputCase{"PlacedOnTheWorld", "add first-steps.toml coulomb_friction --where world", 2,
                     "coulomb_friction cannot be placed on the world; place it on a joint"},
        BadInputCase{"PlacedNowhereOfSeveralPlaces", "add smoke/quadruped-parametric.toml coulomb_friction", 2,
                     "add coulomb_friction: say where: --where joint."},
        BadInputCase{"PlacedOnABody", "add first-steps.toml coulomb_friction --where body.arm", 2,
                     "coulomb_friction cannot be placed on a body; place it on a joint"},
        BadInputCase{"PlacedOnABareName", "add first-steps.toml coulomb_friction --where hinge", 2,
                     "(did you mean \"joint.hinge\"?)"},
        BadInputCase{"IdWithAPoint", kBadId.c_str(), 2, "--id a.b: is not a valid id"},
        BadInputCase{"StartWithoutANumber", kBadStart.c_str(), 2, "--start torque: write PARAMETER=NUMBER"},
        BadInputCase{"StartThatIsNoNumber", kNoStart.c_str(), 2, "--start torque=nan: write PARAMETER=NUMBER"},
        BadInputCase{"StartOfLetters", kWordStart.c_str(), 2, "--start torque=much: write PARAMETER=NUMBER"},
        BadInputCase{"StartOutOfRange", kLowStart.c_str(), 2, "is outside the range of coulomb_friction"},
        BadInputCase{"StartOfAnotherParameter", kOtherStart.c_str(), 2, "(did you mean \"torque\"?)"},
        BadInputCase{"FixedOfAnotherParameter", kOtherFixed.c_str(), 2, "(did you mean \"torque\"?)"},
        BadInputCase{"ListOfNoKind", "plugins list --kind effcts", 2,
                     "--kind effcts: there is no such kind (did you mean \"effect\"?); the kinds are effect, metric, "},
        BadInputCase{"ShowOfAPart", "plugins show coulomb", 2,
                     "there is no plugin \"coulomb\" (did you mean \"coulomb_friction\"?)"}),
    [](const auto& bad) { return bad.param.name; });

}  // namespace
}  // namespace lacuna
