#include "tasks/sweep.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(Sweep, PartsValuesAtCommasOutsideOfBracketsAndQuotes) {
  EXPECT_THAT(read_sweep("engine.step=0.001,0.002"), Pair("engine.step", ElementsAre("0.001", "0.002")));
  EXPECT_THAT(read_sweep("fit.segments=[0.1, 0.5],[0.2]"), Pair("fit.segments", ElementsAre("[0.1, 0.5]", "[0.2]")));
  EXPECT_THAT(read_sweep("model.file=\"a,b.toml\",'c'"), Pair("model.file", ElementsAre("\"a,b.toml\"", "'c'")));
  EXPECT_THAT(read_sweep("model.set.\"a=b\"=1"), Pair("model.set.\"a=b\"", ElementsAre("1")));
}

TEST(Sweep, RefusesWhatHasNoKeyOrNoValue) {
  for (const char* text : {"", "engine.step", "engine.step=", "=1", "a=1,,2", "a=,1"})
    EXPECT_THROW(read_sweep(text), Error) << text;
}

TEST(Sweep, CombinesAllValues) {
  EXPECT_THAT(sweep_points({}), ElementsAre(IsEmpty()));
  EXPECT_THAT(sweep_points({{"a", {"1", "2"}}, {"b", {"x", "y"}}}),
              ElementsAre(ElementsAre("a=1", "b=x"), ElementsAre("a=1", "b=y"), ElementsAre("a=2", "b=x"),
                          ElementsAre("a=2", "b=y")));
}

}  // namespace
}  // namespace lacuna
