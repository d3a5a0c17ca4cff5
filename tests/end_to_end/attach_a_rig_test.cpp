#include "end_to_end/guide.h"
#include "end_to_end/program.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace lacuna {
namespace {

bool has_mujoco() { return std::filesystem::exists(LACUNA_BINARY_DIRECTORY "/bin/mujoco_cart_pole"); }

/// Explore, diagnose, add, and the error falls: the loop on both targets outside, as the tutorial goes round it. All
/// but the part that needs MuJoCo is followed without it, too.
TEST(AttachARig, PrintsWhatItSays) {
  const Program program;
  program.copy_outside_targets();
  follow_guide("docs/tutorials/attach-a-rig.md", program, has_mujoco() ? "" : "## Another engine");
}

}  // namespace
}  // namespace lacuna
