#include "end_to_end/guide.h"
#include "end_to_end/printed_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// The tutorial that ends with a plugin of the reader's own: two diagnoses over the whole library, one compilation.
TEST(AnEffectOfYourOwn, PrintsWhatItSaysAndShowsThePictureThatItDraws) {
  Program program;
  program.copy_damped_flap();
  const Outcome installed = program.install("lacuna");
  ASSERT_EQ(installed.exit_code, 0) << installed.errors;
  follow_guide("docs/tutorials/an-effect-of-your-own.md", program);
  const std::vector<std::string> shown = words_of_picture(source_file("docs/pictures/damped-flap-force.svg"));
  ASSERT_THAT(shown, testing::Contains(testing::HasSubstr("q^2*v")));
  EXPECT_EQ(difference(shown, words_of_picture(program.read("pictures/residual-force-hinge.svg")), kFigureTolerance),
            "");
}

}  // namespace
}  // namespace lacuna
