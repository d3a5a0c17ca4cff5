#include "dirty/write_dirty_case.h"
#include "runs/child_process.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

/// The program takes dirty cases as their owners write them: a fall, an imposed motion, two devices and six servos.
namespace hidden_effects::dirty {
namespace {

TEST(DirtyByProgram, ChecksTheFilesOfItsOwners) {
  const std::vector<DirtyPlan> plans = plan_dirty_cases("dirty-quick");
  for (const std::size_t number : {3U, 5U, 28U}) {
    const lacuna::TestFolder folder;
    write_dirty_case(make_dirty_case(plans[number]), folder.path());
    const ChildOutcome outcome = run_child({LACUNA_BINARY_DIRECTORY "/bin/lacuna", "check", "rig.toml"}, folder.path(),
                                           60.0, [] { return false; });
    EXPECT_EQ(outcome.code, 0) << plans[number].name() << outcome.errors;
    EXPECT_NE(outcome.output.find("rig.toml: ok"), std::string::npos) << outcome.output;
  }
}

}  // namespace
}  // namespace hidden_effects::dirty
