#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

class EchoProgram : public ExternalProgram {
 public:
  Trial carry_out(const lacuna::Test& test) override {
    Trial trial;
    trial.name = "lasts " + std::to_string(test.duration);
    return trial;
  }
};

TEST(ProcessPlugin, HandsATestToTheHostsProgram) {
  EchoProgram program;
  const auto target = built_catalog().make<TargetSystem>("process");
  lacuna::Test test;
  test.duration = 2.5;
  EXPECT_TRUE(target->takes_tests());
  EXPECT_EQ(target->carry_out(test, {.program = &program}).name, "lasts 2.500000");
  EXPECT_TRUE(target->recorded({.program = &program}).empty());
}

TEST(ProcessPlugin, WithoutAProgramSaysWhatToGive) {
  const auto target = built_catalog().make<TargetSystem>("process");
  EXPECT_THAT([&] { target->carry_out({}, {}); }, testing::ThrowsMessage<Error>(testing::HasSubstr("[target]")));
}

}  // namespace
}  // namespace lacuna
