#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class TwoTrials : public TrialReader {
 public:
  std::vector<Trial> read() const override {
    std::vector<Trial> trials(2);
    trials[0].name = "sine";
    trials[1].name = "chirp";
    return trials;
  }
};

TEST(Recorded, HandsOnWhatTheHostReads) {
  const TwoTrials reader;
  const std::vector<Trial> trials = built_catalog().make<TargetSystem>("recorded")->recorded({.trials = &reader});
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_EQ(trials[1].name, "chirp");
}

TEST(Recorded, WithoutAReaderSaysWhatToName) {
  const auto target = built_catalog().make<TargetSystem>("recorded");
  EXPECT_THAT([&] { target->recorded({}); }, ThrowsMessage<Error>(HasSubstr("[target]")));
}

TEST(Recorded, TakesNoTests) {
  const auto target = built_catalog().make<TargetSystem>("recorded");
  EXPECT_FALSE(target->takes_tests());
  EXPECT_THAT([&] { target->carry_out({}, {}); }, ThrowsMessage<Error>(HasSubstr("takes no tests")));
}

TEST(Recorded, EachTargetIsItsOwn) {
  EXPECT_NE(built_catalog().make<TargetSystem>("recorded"), built_catalog().make<TargetSystem>("recorded"));
}

}  // namespace
}  // namespace lacuna
