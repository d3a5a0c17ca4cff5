#include "app/terminal/time_limit.h"

#include "foundation/text/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

std::string refusal_of(const std::string& text) {
  try {
    parse_duration("--time-limit", text);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "";
}

TEST(TimeLimitOption, TakesSecondsOrAUnitOfTime) {
  EXPECT_DOUBLE_EQ(parse_duration("--time-limit", "90"), 90.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time-limit", "0.5"), 0.5);
  EXPECT_DOUBLE_EQ(parse_duration("--time-limit", "5 min"), 300.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time-limit", "5min"), 300.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time-limit", "1.5 h"), 5400.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time-limit", "200 ms"), 0.2);
}

TEST(TimeLimitOption, RefusesWhatIsNoDurationAndSaysWhatToWrite) {
  for (const char* text : {"", "soon", "5 minutes", "nan", "inf"})
    EXPECT_THAT(refusal_of(text), testing::HasSubstr("is not a duration; write seconds")) << text;
  EXPECT_THAT(refusal_of("5 m"), testing::HasSubstr("m is not a unit of time; write seconds"));
  EXPECT_THAT(refusal_of("1 %"), testing::HasSubstr("% is not a unit of time"));
  for (const char* text : {"0", "-3", "-1 min"})
    EXPECT_THAT(refusal_of(text), testing::HasSubstr("must be longer than 0")) << text;
}

}  // namespace
}  // namespace lacuna
