#include "end_to_end/program.h"
#include "support/small_experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

/// Tasks of a plan, as processes on one machine carry them out.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Stands in for Slurm where there is none: carries the tasks out one after the other, in the order that it is given.
constexpr const char* kSbatch = R"(#!/bin/sh
echo "$*" >> calls
for word; do
  case $word in
    --array=*) numbers=$(echo "${word#--array=}" | sed 's/-/ /') ;;
    *.sh) script=$word ;;
  esac
done
if [ -n "$numbers" ]; then
  for number in $(seq $numbers); do SLURM_ARRAY_TASK_ID=$number sh "$script" >> printed 2>&1; done
else
  sh "$script" >> printed 2>&1
fi
echo 17
)";

class Plan : public testing::Test {
 protected:
  Plan() { write_small("0.2", 4); }

  void write_small(const std::string& duration, int generations) const {
    const std::string search = "population = 12, keep = 6, generations = " + std::to_string(generations);
    program_.write("small.toml", small_experiment(duration, search, search));
  }
  std::string lacuna(const std::string& line) const {
    const Outcome outcome = program_.shell("lacuna " + line);
    EXPECT_EQ(outcome.exit_code, 0) << line << ": " << outcome.errors;
    return outcome.output;
  }
  std::string hashes(const std::string& database) const { return lacuna("hash " + database); }

  Program program_;
};

TEST_F(Plan, MergesToWhatOneProcessStores) {
  lacuna("run small.toml --replicates 3 --db serial.db --quiet");
  lacuna("plan small.toml --replicates 3 --out plan");
  for (const char* number : {"2", "0", "1"}) lacuna("task run plan " + std::string(number) + " --quiet");
  EXPECT_THAT(lacuna("merge all.db plan"), HasSubstr("all.db: 3 runs added"));
  EXPECT_EQ(hashes("all.db"), hashes("serial.db"));
  EXPECT_THAT(lacuna("merge all.db plan plan/shards/1.db"), HasSubstr("0 runs added, 4 there already"));
  EXPECT_EQ(hashes("all.db"), hashes("serial.db"));
  EXPECT_THAT(lacuna("verify all.db"), HasSubstr("3 runs as stored"));
}

TEST_F(Plan, HasATaskForEachPointOfASweep) {
  program_.write("small.toml", program_.read("small.toml") + "\n[sweep]\n\"estimation.restarts\" = [1, 2]\n");
  EXPECT_THAT(lacuna("plan small.toml --replicates 2 --sweep experiment.passes=1,2 --out plan"),
              HasSubstr("plan: 8 tasks"));
  EXPECT_THAT(program_.read("plan/plan.json"), HasSubstr("estimation.restarts=2"));
  lacuna("task run plan 7 --quiet");
  lacuna("run small.toml --set estimation.restarts=2 --set experiment.passes=2 --replicates 2 --db s.db --quiet");
  EXPECT_THAT(hashes("s.db"), HasSubstr(hashes("plan/shards/7.db").substr(0, 64)));
}

TEST_F(Plan, DiagnosesExperiments) {
  program_.copy_first_steps();
  lacuna("diagnose first-steps.toml --db serial.db --quiet --json=serial.json");
  lacuna("plan first-steps.toml --diagnose --out plan");
  lacuna("task run plan 0 --quiet");
  lacuna("merge all.db plan");
  EXPECT_THAT(lacuna("diagnose first-steps.toml --db all.db --json=merged.json"), HasSubstr("(from the database)"));
  const std::regex time("\"seconds\": [0-9.]+");
  EXPECT_EQ(std::regex_replace(program_.read("merged.json"), time, ""),
            std::regex_replace(program_.read("serial.json"), time, ""));
}

/// As a batch system ends it before its time is up.
TEST_F(Plan, GoesOnFromACheckpoint) {
  write_small("0.5", 240);
  lacuna("run small.toml --db serial.db --quiet");
  lacuna("plan small.toml --out plan");
  const std::string task = "lacuna task run plan 0 --quiet";
  for (const char* signal : {"USR1", "TERM"}) {
    const Outcome outcome = program_.shell("timeout --preserve-status -s " + std::string(signal) + " 1 " + task);
    EXPECT_EQ(outcome.exit_code, 75) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("task 0 was interrupted"));
    EXPECT_THAT(lacuna("status plan"), HasSubstr("1 interrupted (0)"));
  }
  lacuna("task run plan 0 --quiet");
  EXPECT_EQ(hashes("plan/shards/0.db"), hashes("serial.db"));
  EXPECT_EQ(program_.shell("ls plan/checkpoints").output, "");
}

TEST_F(Plan, ATaskThatTwoProcessesCarryOutIsThereOnce) {
  lacuna("plan small.toml --out plan");
  const Outcome both = program_.shell(
      "lacuna task run plan 0 --quiet & lacuna task run plan 0 --quiet > /dev/null; code=$?; wait $! && exit $code");
  EXPECT_EQ(both.exit_code, 0) << both.errors;
  EXPECT_THAT(lacuna("merge all.db plan"), HasSubstr("1 run added"));
  EXPECT_THAT(lacuna("task run plan 0"), HasSubstr("task 0 is done"));
}

TEST_F(Plan, NamesTasksThatFail) {
  lacuna("plan small.toml --replicates 2 --out plan");
  lacuna("task run plan 0 --quiet");
  program_.write("small.toml", program_.read("small.toml") + "# another file\n");
  const Outcome refused = program_.shell("lacuna task run plan 1");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("small.toml is not as it was when the plan was made")));
  EXPECT_THAT(lacuna("status plan"), AllOf(HasSubstr("task 1 failed ("), HasSubstr("1 failed (1), 1 done (0)")));
  const Outcome merge = program_.shell("lacuna merge all.db plan");
  EXPECT_EQ(merge.exit_code, 1);
  EXPECT_THAT(merge.errors, AllOf(HasSubstr("plan: task 1 failed: "), HasSubstr("1 of 2 tasks are merged")));
  EXPECT_THAT(merge.output, HasSubstr("all.db: 1 run added"));
}

TEST_F(Plan, RefusesWhatCannotBePlanned) {
  program_.write("other.toml", program_.read("small.toml"));
  const Outcome refused = program_.shell("lacuna plan small.toml other.toml nothing.toml --out plan");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("nothing.toml"), HasSubstr("other.toml: is called small, as ")));
  EXPECT_EQ(program_.shell("lacuna plan small.toml --diagnose --out plan").exit_code, 2);
  EXPECT_EQ(program_.shell("lacuna plan small.toml --sweep experiment.passes=1,1 --out plan").exit_code, 2);
  EXPECT_EQ(program_.shell("lacuna plan small.toml --sweep experiment.pases=1 --out plan").exit_code, 2);
  EXPECT_EQ(program_.shell("ls plan").exit_code, 2) << "nothing was made";
  EXPECT_EQ(program_.shell("lacuna status .").exit_code, 2);
  EXPECT_EQ(program_.shell("lacuna task run . 0").exit_code, 2);
}

TEST_F(Plan, GoesToSlurm) {
  program_.write("sbatch", kSbatch);
  program_.shell("chmod +x sbatch");
  const std::string run =
      "PATH=.:$PATH lacuna run small.toml --replicates 2 --executor slurm --sbatch '--time=5 -p long'";
  const Outcome submitted = program_.shell(run);
  EXPECT_EQ(submitted.exit_code, 0) << submitted.errors;
  EXPECT_THAT(submitted.output,
              AllOf(HasSubstr("Slurm job 17: 2 tasks; job 17 then merges"), HasSubstr("lacuna status")));
  EXPECT_THAT(program_.read("calls"), AllOf(HasSubstr("--array=0-1"), HasSubstr("--requeue"),
                                            HasSubstr("--time=5 -p long"), HasSubstr("--dependency=afterany:17")));
  lacuna("run small.toml --replicates 2 --db serial.db --quiet");
  EXPECT_EQ(hashes("small.db"), hashes("serial.db"));
  EXPECT_THAT(program_.shell(run).output, HasSubstr("all 2 tasks of"));
  EXPECT_EQ(program_.shell("lacuna run small.toml --executor slurm --db other.db").exit_code, 2)
      << "another plan is there";
}

TEST_F(Plan, SaysWhatSlurmSays) {
  program_.write("sbatch", "#!/bin/sh\necho 'invalid partition specified: long' >&2\nexit 1\n");
  const Outcome refused =
      program_.shell("chmod +x sbatch; PATH=.:$PATH lacuna run small.toml --executor slurm --sbatch --partition=long");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("--partition=long"), HasSubstr("invalid partition specified: long")));
}

}  // namespace
}  // namespace lacuna
