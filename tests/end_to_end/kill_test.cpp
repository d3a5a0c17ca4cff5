#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

namespace lacuna {
namespace {

constexpr int kKills = 50;
constexpr int kKilled = 128 + SIGKILL;
constexpr std::uint64_t kSeed = 20;  // of the moments

/// A run that is killed again and again, and gone on with each time, ends with the rows of one that was not.
TEST(Kill, FiftyTimesAtRandomMomentsLosesNothing) {
  const Program program;
  program.write("small.toml", kSmallRun);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(program.run({"run", "small.toml", "--db", "whole.db"}).exit_code, 0);
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto hash = [&](const char* database) {
    const std::string line = program.run({"hash", database}).output;
    return line.substr(0, line.find(' '));
  };

  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> moment(0.0, whole);
  int killed = 0, ended = 0;
  bool resumes = false;
  while (killed < kKills) {
    const auto wait = std::chrono::duration<double>(moment(random));
    const auto start = std::chrono::steady_clock::now();
    const std::vector<std::string> fresh = {"run", "small.toml"}, again = {"run", "small.toml", "--resume"};
    const Outcome outcome = program.run_and_signal(
        resumes ? again : fresh, [&] { return std::chrono::steady_clock::now() - start >= wait; }, SIGKILL);
    if (outcome.exit_code == kKilled) {
      ++killed;
      // Killed before its run was begun, there is nothing to go on with.
      resumes = program.run({"runs", "small.db"}).output.find("not ended") != std::string::npos;
      const Outcome check = program.shell("sqlite3 small.db 'PRAGMA integrity_check'");
      if (std::filesystem::exists(program.folder() / "small.db")) {
        EXPECT_EQ(check.output, "ok\n");
      }
      continue;
    }
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    ++ended;
    EXPECT_EQ(hash("small.db"), hash("whole.db"));
    for (const char* file : {"small.db", "small.db-wal", "small.db-shm"})
      std::filesystem::remove(program.folder() / file);
    resumes = false;
  }
  if (resumes) {
    ASSERT_EQ(program.run({"run", "small.toml", "--resume"}).exit_code, 0);
    EXPECT_EQ(hash("small.db"), hash("whole.db"));
  }
  RecordProperty("ended", ended);
}

}  // namespace
}  // namespace lacuna
