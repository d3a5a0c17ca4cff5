#include "app/runs/replays.h"

#include "end_to_end/program.h"
#include "end_to_end/small_run.h"
#include "storage/queries/page_query.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr std::size_t kPlenty = 12'000'000;

class ReplaysTest : public testing::Test {
 protected:
  void run(const std::string& experiment, const std::string& database, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"run", at(experiment).string(), "--db", database, "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = program_.run(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
  std::filesystem::path at(const std::string& name) const { return program_.folder() / name; }
  /// The one column of a query as text.
  std::vector<std::string> asked(const std::string& sql) const {
    std::vector<std::string> cells;
    for (const std::vector<PageCell>& row : ask_for_page(at("run.db"), at("pages.db"), {.sql = sql}).rows)
      cells.push_back(std::get<std::string>(row.at(0)));
    return cells;
  }

  Program program_;
};

const std::vector<std::string> kShort = {"--set", "estimation.parameters.generations=2",
                                         "--set", "estimation.parameters.population=10",
                                         "--set", "estimation.parameters.keep=5"};

TEST_F(ReplaysTest, AreThereForEveryTrialTheLastOneIncluded) {
  program_.copy_first_steps();
  run("first-steps.toml", "run.db", kShort);  // one pass over two recorded trials
  program_.write("small.toml", kSmallRun);
  run("small.toml", "run.db", {"--set", "model.approximate=true"});  // pass 0 has no trial
  PageDatabase pages(at("pages.db"));
  Replays(at("run.db"), {}, pages).prepare_for_report(kPlenty);
  EXPECT_EQ(asked("SELECT group_concat(run || '/' || trial, ' ') FROM (SELECT * FROM page_replay ORDER BY run, trial)"),
            std::vector<std::string>{"1/1 2/0 2/1 2/2"})
      << "all of the newest run and one of the other";
  EXPECT_EQ(asked("SELECT DISTINCT kind FROM page_replay_trace WHERE kind LIKE '% contacts' ORDER BY kind"),
            (std::vector<std::string>{"model contacts", "target contacts"}));
  EXPECT_THAT(asked("SELECT sentence FROM page_note"), testing::IsEmpty());
}

TEST_F(ReplaysTest, AreThereForOtherExperimentsWhereOneCannotBeReadAndItsFoldersStayUntold) {
  program_.write("small.toml", kSmallRun);
  run("small.toml", "run.db");
  program_.copy_first_steps();
  run("first-steps.toml", "run.db", kShort);
  std::filesystem::remove(at("robots/servo-pendulum.toml"));
  PageDatabase pages(at("pages.db"));
  Replays(at("run.db"), {}, pages).prepare_for_report(kPlenty);
  EXPECT_EQ(asked("SELECT group_concat(trial, ' ') FROM (SELECT * FROM page_replay WHERE run = 1 ORDER BY trial)"),
            std::vector<std::string>{"0 1 2"});
  const std::vector<std::string> notes = asked("SELECT sentence FROM page_note");
  EXPECT_THAT(notes, Contains(HasSubstr("The robots of run 2 are not shown: ")));
  EXPECT_THAT(notes, Not(Contains(HasSubstr(program_.folder().string()))));
}

TEST_F(ReplaysTest, AreThoseOfTheFileThatTookAnothersPlace) {
  program_.write("small.toml", kSmallRun);
  run("small.toml", "run.db");
  run("small.toml", "other.db", {"--seed", "9"});
  PageDatabase pages(at("pages.db"));
  Replays replays(at("run.db"), {}, pages);
  const std::int64_t first = replays.prepare(1, 0);
  EXPECT_EQ(replays.prepare(1, 0), first);
  std::filesystem::rename(at("other.db"), at("run.db"));
  const std::int64_t second = replays.prepare(1, 0);
  EXPECT_NE(second, first);
  EXPECT_EQ(asked("SELECT identity FROM page_replay WHERE id = " + std::to_string(second)),
            asked("SELECT identity FROM run"));
  EXPECT_THROW(replays.prepare(1, 99), Error);
}

}  // namespace
}  // namespace lacuna
