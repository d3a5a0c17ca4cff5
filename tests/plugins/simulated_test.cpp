#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class EchoSimulator : public Simulator {
 public:
  Trial simulate(const lacuna::Test& test) const override {
    Trial trial;
    trial.name = "lasts " + std::to_string(test.duration);
    return trial;
  }
};

TEST(Simulated, CarriesOutATestInTheHostsSimulator) {
  const EchoSimulator simulator;
  const auto target = built_catalog().make<TargetSystem>("simulated");
  lacuna::Test test;
  test.duration = 2.5;
  EXPECT_TRUE(target->takes_tests());
  EXPECT_EQ(target->carry_out(test, {.simulator = &simulator}).name, "lasts 2.500000");
  EXPECT_TRUE(target->recorded({.simulator = &simulator}).empty());
}

TEST(Simulated, WithoutASimulatorSaysWhatToGive) {
  const auto target = built_catalog().make<TargetSystem>("simulated");
  EXPECT_THAT([&] { target->carry_out({}, {}); }, ThrowsMessage<Error>(HasSubstr("[target]")));
}

}  // namespace
}  // namespace lacuna
