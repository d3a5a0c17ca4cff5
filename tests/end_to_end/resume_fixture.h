#pragma once

#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr int kDone = 0, kBadInput = 2, kInterrupted = 75;

/// A folder with small.toml and a database small.db.
class Resume : public testing::Test {
 protected:
  Resume() { program_.write("small.toml", kSmallRun); }

  /// Begins a run in small.db and interrupts it after its first trial, or in the midst of an estimation phase.
  void interrupt(const std::vector<std::string>& options, bool in_estimation = false) const {
    std::vector<std::string> arguments = {"run", "small.toml", "--json=lines", "--threads", "1"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    program_.write("lines", "");
    const auto ready = [&] {
      const std::string lines = program_.read("lines");
      return lines.find("\"trial\"") != std::string::npos &&
             (!in_estimation || lines.find("\"progress\"") != std::string::npos);
    };
    ASSERT_EQ(program_.run_and_signal(arguments, ready, SIGINT).exit_code, kInterrupted);
  }
  /// Another database is copied over small.db while it runs.
  Outcome run_and_copy_over(const std::vector<std::string>& options) const {
    EXPECT_EQ(program_.run({"run", "small.toml", "--db", "theirs.db"}).exit_code, kDone);
    std::vector<std::string> arguments = {"run", "small.toml", "--json=lines"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    program_.write("lines", "");
    const auto copy = [&] {
      if (program_.read("lines").find("\"trial\"") == std::string::npos) return false;
      return program_.shell("cp theirs.db small.db").exit_code == 0;
    };
    return program_.run_and_signal(arguments, copy, SIGCONT);
  }
  std::string ask(const std::string& database, const std::string& sql) const {
    return program_.run({"sql", database, sql, "--csv"}).output;
  }
  std::string hash(const std::string& database, int run = 1) const {
    return program_.run({"hash", database, "--run", std::to_string(run)}).output.substr(0, 64);
  }

  Program program_;
};

}  // namespace lacuna
