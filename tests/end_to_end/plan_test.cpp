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
using testing::Not;

/// Stands in for Slurm where there is none: carries the tasks out one after the other, in the order that it is given.
constexpr const char* kSbatch = R"(#!/bin/sh
echo "$*" >> calls
for word; do
  case $word in
    --array=*) numbers=$(echo "${word#--array=}" | sed 's/-/ /') ;;
    *.sh) script=$word ;;
  esac
done
shell=$(sed -n '1s/^#!//p' "$script")
if [ -n "$numbers" ]; then
  for number in $(seq $numbers); do SLURM_ARRAY_TASK_ID=$number $shell "$script" >> printed 2>&1; done
else
  $shell "$script" >> printed 2>&1
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
  EXPECT_THAT(lacuna("merge all.db plan plan/shards/1.db"), HasSubstr("0 runs added, 4 already present"));
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

/// As a plugin ends it, the system where memory is used up, or a shell that is closed.
TEST_F(Plan, WhatAProcessHasFoundThatWasKilledIsACheckpoint) {
  write_small("0.5", 240);
  lacuna("run small.toml --db serial.db --quiet");
  lacuna("plan small.toml --out plan");
  const auto kill = [&](const std::string& signal, long bytes) {  // once it has written so much
    return program_.shell(
        "TMPDIR=$PWD lacuna task run plan 0 --threads 1 --quiet & until [ $(stat -c %s "
        "lacuna-scratch-*/shard.db-wal 2>/dev/null || echo 0) -gt " +
        std::to_string(bytes) + " ]; do kill -0 $! || exit 3; sleep 0.01; done; pkill -" + signal +
        " -P $!; wait $!; code=$?; ls -d lacuna-*; exit $code");
  };
  const Outcome hung_up = kill("HUP", 0);
  EXPECT_EQ(hung_up.exit_code, 129) << hung_up.errors;
  EXPECT_THAT(hung_up.errors, AllOf(HasSubstr("interrupted by signal 1 (Hangup)"), HasSubstr("to continue: lacuna")));
  EXPECT_EQ(hung_up.output, "") << "no folder is left";
  const Outcome killed = kill("KILL", 500'000);
  EXPECT_EQ(killed.exit_code, 1) << killed.errors;
  EXPECT_THAT(killed.errors, HasSubstr("task 0 has a checkpoint with its results so far; to continue: "
                                       "lacuna task run plan 0"));
  EXPECT_EQ(killed.output, "");
  EXPECT_THAT(lacuna("status plan"), AllOf(HasSubstr("task 0 failed ("), HasSubstr("was ended by signal 9 (Killed)")));
  EXPECT_EQ(program_.shell("ls plan/checkpoints").output, "0.db\n");
  lacuna("task run plan 0 --quiet");
  EXPECT_EQ(hashes("plan/shards/0.db"), hashes("serial.db"));
}

/// Where the plan's folder cannot be reached either.
TEST_F(Plan, WhatAKilledProcessCannotHandInIsKeptAndNamed) {
  write_small("0.5", 240);
  lacuna("plan small.toml --out plan");
  const Outcome killed = program_.shell(
      "TMPDIR=$PWD lacuna task run plan 0 --threads 1 --quiet & until [ -s lacuna-scratch-*/shard.db-wal ]; do kill -0 "
      "$! || exit 3; sleep 0.01; done; rmdir plan/shards; ln -s shards plan/shards; pkill -KILL -P $!; wait $!");
  EXPECT_EQ(killed.exit_code, 1) << killed.errors;
  EXPECT_THAT(killed.errors, HasSubstr("the results so far are in "));
  EXPECT_THAT(lacuna("verify lacuna-kept-*/shard.db"), HasSubstr("shard.db: intact"));
  const std::string advice = killed.errors.substr(killed.errors.find("run: cp ") + 5);
  program_.shell("rm plan/shards; mkdir plan/shards; " + advice);
  EXPECT_EQ(program_.shell("ls plan/checkpoints").output, "0.db\n") << advice;
  lacuna("task run plan 0 --quiet");
  EXPECT_THAT(lacuna("merge all.db plan"), HasSubstr("1 run added"));
}

TEST_F(Plan, ACheckpointThatCannotBeUsedIsPutAside) {
  lacuna("plan small.toml --replicates 2 --out plan");
  program_.write("plan/checkpoints/0.db", "no database at all, whatever its name says");
  const Outcome anew = program_.shell("lacuna task run plan 0 --quiet");
  EXPECT_EQ(anew.exit_code, 0);
  EXPECT_THAT(anew.errors, AllOf(HasSubstr("plan/checkpoints/0.db: is not a Lacuna database"),
                                 HasSubstr("it is kept as plan/checkpoints/0.db.unusable, and the task starts again")));
  program_.shell("cp plan/shards/0.db plan/checkpoints/1.db");
  EXPECT_THAT(program_.shell("lacuna task run plan 1 --quiet").errors,
              HasSubstr("plan/checkpoints/1.db: contains results of another task"));
  EXPECT_THAT(lacuna("merge all.db plan"), HasSubstr("2 runs added"));
}

/// Results that cannot be handed in stay where they are, and are named.
TEST_F(Plan, AFullFolderLosesNothing) {
  const Outcome full = program_.shell(
      "mkdir full && unshare --mount sh -c 'mount -t tmpfs -o size=300k none full || { echo no mount; exit; }; "
      "lacuna plan small.toml --out full/plan; TMPDIR=$PWD lacuna task run full/plan 0 --quiet; echo $?; "
      "ls full/plan/shards full/plan/checkpoints; lacuna status full/plan'");
  if (full.output.find("no mount") != std::string::npos || full.errors.find("unshare") != std::string::npos)
    GTEST_SKIP() << "a file system of its own cannot be mounted here; it takes root";
  EXPECT_THAT(full.errors, AllOf(HasSubstr("full/plan/shards/0.db: cannot grow: the disk or the quota is full"),
                                 HasSubstr("the results so far are in ")));
  EXPECT_THAT(full.output,
              AllOf(HasSubstr("\n1\nfull/plan/checkpoints:\n\nfull/plan/shards:\n"), HasSubstr("task 0 failed (")));
  EXPECT_THAT(lacuna("verify lacuna-kept-*/shard.db"), HasSubstr("1 run as stored"));
}

TEST_F(Plan, ALostPlanIsMadeAnewAroundWhatItsTasksHaveFound) {
  lacuna("plan small.toml --replicates 2 --out plan");
  lacuna("task run plan 0 --quiet");
  program_.write("plan/plan.json", "{");
  EXPECT_THAT(program_.shell("lacuna status plan").errors, HasSubstr("restore a copy, or remove it and make the plan"));
  program_.shell("rm plan/plan.json");
  EXPECT_EQ(program_.shell("lacuna plan small.toml --seed 9 --out plan").exit_code, 2) << "of another plan";
  EXPECT_THAT(lacuna("plan small.toml --replicates 2 --out plan"), HasSubstr("plan: 2 tasks"));
  EXPECT_THAT(lacuna("status plan"), HasSubstr("1 done (0)"));
}

TEST_F(Plan, LeavesOutShardsThatAreNotOfTheirTasks) {
  lacuna("plan small.toml --replicates 3 --out plan");
  for (const char* number : {"0", "1"}) lacuna("task run plan " + std::string(number) + " --quiet");
  program_.shell("cp plan/shards/1.db plan/shards/2.db; truncate -s 100000 plan/shards/0.db");
  const Outcome merge = program_.shell("lacuna merge all.db plan");
  EXPECT_EQ(merge.exit_code, 1);
  EXPECT_THAT(merge.output, HasSubstr("all.db: 1 run added"));
  EXPECT_EQ(program_.shell("ls | grep all.db-").output, "") << "no log is left";
  EXPECT_THAT(merge.errors, AllOf(HasSubstr("plan/shards/2.db: contains results of another task; move it "
                                            "away and carry the task out again: lacuna task run plan 2"),
                                  HasSubstr("plan/shards/0.db: is damaged"), HasSubstr("1 of 3 tasks are merged")));
  program_.shell("sqlite3 plan/shards/1.db 'UPDATE model SET score = score * 2 + 1'");
  const Outcome nothing = program_.shell("lacuna merge new.db plan");
  EXPECT_THAT(nothing.errors, HasSubstr("plan/shards/1.db: rows differ from what was stored; move it away and carry "
                                        "the task out again: lacuna task run plan 1"));
  EXPECT_THAT(nothing.errors, HasSubstr("0 of 3 tasks are merged"));
  EXPECT_EQ(program_.shell("ls new.db").exit_code, 2) << "nothing was made";
  EXPECT_EQ(program_.shell("lacuna merge all.db plan plan/shards/1.db").exit_code, 2) << "named for itself";
}

/// What another shard would not mend.
TEST_F(Plan, AShardOfANewerVersionIsNotToBeRemoved) {
  lacuna("plan small.toml --out plan");
  lacuna("task run plan 0 --quiet");
  program_.shell("sqlite3 plan/shards/0.db 'PRAGMA user_version = 999'");
  const Outcome merge = program_.shell("lacuna merge all.db plan");
  EXPECT_EQ(merge.exit_code, 1);
  EXPECT_THAT(merge.errors, AllOf(HasSubstr("plan/shards/0.db: "), HasSubstr("newer"), Not(HasSubstr("move it away"))));
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
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("small.toml has changed since the plan was made")));
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
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("nothing.toml"), HasSubstr("other.toml: has the name small, which ")));
  EXPECT_EQ(program_.shell("lacuna plan small.toml --diagnose --out plan").exit_code, 2);
  EXPECT_EQ(program_.shell("lacuna plan small.toml --sweep experiment.passes=1,1 --out plan").exit_code, 2);
  const Outcome unknown = program_.shell("lacuna plan small.toml --sweep experiment.pases=1 --out plan");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("small.toml: sweep: experiment.pases=1: experiment: unknown key"));
  EXPECT_THAT(
      program_.shell("lacuna plan small.toml --sweep experiment.passes=1,2 --set experiment.passes=3 --out plan")
          .errors,
      HasSubstr("--set experiment.passes=3: this key is swept"));
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
  program_.shell("rm -r small.plan calls");
  for (const char* unusable : {"small.toml", "no-such-folder/all.db", "."})
    EXPECT_NE(program_.shell(run + " --db " + unusable).exit_code, 0) << unusable;
  EXPECT_EQ(program_.shell("ls small.plan calls").output, "") << "nothing was submitted";
  program_.shell(run + " --db other.db");
  EXPECT_EQ(program_.shell("lacuna run small.toml --executor slurm --db other.db").exit_code, 2)
      << "another plan is there";
}

/// Shells quote such names in ways that not all of them read, and Slurm replaces what begins with %.
TEST_F(Plan, GoesToSlurmFromAFolderOfAnyName) {
  program_.shell("mkdir \"$(printf 'it\\047s 50%%\\ta')\" && cp small.toml it*");
  program_.write("sbatch", kSbatch);
  const Outcome submitted = program_.shell(
      "chmod +x sbatch; here=$PWD; cd it*; PATH=$here:$PATH lacuna run small.toml --replicates 2 --executor slurm && "
      "cat printed && lacuna runs small.db");
  EXPECT_EQ(submitted.exit_code, 0) << submitted.errors;
  EXPECT_THAT(submitted.output, HasSubstr("small.db: 2 runs added"));
  EXPECT_THAT(program_.shell("cat it*/calls").output, HasSubstr("s 50%%"));
}

TEST_F(Plan, SaysWhatSlurmSays) {
  program_.write("sbatch", "#!/bin/sh\necho 'invalid partition specified: long' >&2\nexit 1\n");
  const Outcome refused =
      program_.shell("chmod +x sbatch; PATH=.:$PATH lacuna run small.toml --executor slurm --sbatch --partition=long");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("--partition=long"), HasSubstr("invalid partition specified: long")));
  const auto submission = [&](const std::string& sbatch) {
    program_.write("sbatch", "#!/bin/sh\n" + sbatch + "\n");
    return program_.shell("PATH=.:$PATH lacuna run small.toml --executor slurm").errors;
  };
  EXPECT_THAT(submission("echo welcome"), HasSubstr("answered without the number of a job: welcome"));
  EXPECT_THAT(submission("exit 127"), HasSubstr("sbatch was not found"));
  EXPECT_THAT(submission("case \"$*\" in *dependency*) echo no more jobs >&2; exit 1;; esac; echo 18"),
              AllOf(HasSubstr("no more jobs"),
                    HasSubstr("the tasks are submitted as Slurm job 18; when it has ended: lacuna merge ")));
}

}  // namespace
}  // namespace lacuna
