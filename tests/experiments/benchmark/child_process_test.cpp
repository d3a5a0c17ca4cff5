#include "runs/child_process.h"

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace hidden_effects {
namespace {

class ChildProcess : public testing::Test {
 protected:
  ChildOutcome run(const std::string& script, double longest = 60.0, bool stop = false) {
    return run_child({"/bin/sh", "-c", script}, folder_.path(), longest, [stop] { return stop; });
  }
  lacuna::TestFolder folder_;
};

TEST_F(ChildProcess, TellsWhatItWroteAndHowItEnded) {
  const ChildOutcome outcome = run("pwd; echo wrong >&2; exit 3");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.output, folder_.path().string() + "\n");
  EXPECT_EQ(outcome.errors, "wrong\n");
  EXPECT_FALSE(outcome.timed_out);
}

TEST_F(ChildProcess, TellsTheSignalOfACrash) { EXPECT_EQ(run("kill -SEGV $$").code, 128 + 11); }

TEST_F(ChildProcess, EndsWhatTakesTooLong) {
  const ChildOutcome outcome = run("sleep 100", 0.2);
  EXPECT_TRUE(outcome.timed_out);
  EXPECT_LT(outcome.seconds, 50.0);
}

TEST_F(ChildProcess, EndsWhenItIsToStop) {
  const ChildOutcome outcome = run("sleep 100", 60.0, true);
  EXPECT_TRUE(outcome.stopped);
  EXPECT_FALSE(outcome.timed_out);
}

TEST_F(ChildProcess, CountsProcessorTime) {
  const ChildOutcome outcome = run("i=0; while [ $i -lt 200000 ]; do i=$((i + 1)); done");
  EXPECT_GT(outcome.processor_seconds, 0.01);
}

TEST_F(ChildProcess, AProgramThatIsNotThereIsSaid) {
  EXPECT_THROW(run_child({"/no/such/program"}, folder_.path(), 1.0, [] { return false; }), std::runtime_error);
}

}  // namespace
}  // namespace hidden_effects
