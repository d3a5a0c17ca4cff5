#include "search/promise_order.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

/// A look of which each effect gains evenly over four blocks of time, but for what is said.
class PromiseOrderTest : public testing::Test {
 protected:
  PromiseOrderTest() { look_.cost = 2.0; }

  void promise(const std::string& effect, double gain, std::size_t values = 1, double more_at_first = 0.0) {
    Hypothesis hypothesis;
    hypothesis.entry.effect = effect;
    hypothesis.entry.where = {"joint.hinge"};
    hypothesis.own.resize(values);
    look_.hypotheses.push_back(std::move(hypothesis));
    Eigen::VectorXd gains = Eigen::VectorXd::Constant(4, gain / 4.0);
    gains(0) += more_at_first;
    gains(3) -= more_at_first;
    look_.promises.push_back({look_.hypotheses.size() - 1, look_.cost - gain, {}, {}, gains});
  }

  std::vector<std::string> names(const std::vector<EffectPromise>& promises) const {
    std::vector<std::string> all;
    for (const EffectPromise& one : promises) all.push_back(look_.hypotheses[one.hypothesis].entry.effect);
    return all;
  }

  EffectLook look_;
};

TEST_F(PromiseOrderTest, TakesTheMostPromisingOfThoseThatDiffer) {
  promise("friction", 1.0);
  promise("same friction", 1.0);
  promise("spring", 0.9, 1, 0.2);
  promise("drag", 0.8, 1, -0.2);
  promise("nothing", 0.05, 1, 0.1);
  EXPECT_THAT(names(best_promises(look_, {}, 2)), testing::ElementsAre("friction", "spring"));
  EXPECT_THAT(names(best_promises(look_, {}, 9)), testing::ElementsAre("friction", "spring", "drag"));
  EXPECT_THAT(names(best_promises(look_, {"friction @ joint.hinge"}, 1)), testing::ElementsAre("same friction"));
}

TEST_F(PromiseOrderTest, PrefersFewerValuesWhereTheyGainNearlyAsMuch) {
  promise("rich", 1.0, 4);
  promise("simple", 0.9, 1, 0.2);
  EXPECT_THAT(names(best_promises(look_, {}, 1)), testing::ElementsAre("simple"));
}

TEST_F(PromiseOrderTest, KnowsWhatPromisesTheSame) {
  promise("friction", 1.0);
  promise("same friction", 1.0, 3);
  promise("as much elsewhere", 1.0, 1, 0.2);
  EXPECT_THAT(names(twins_of(look_, "friction @ joint.hinge")), testing::ElementsAre("same friction"));
  EXPECT_TRUE(twins_of(look_, "drag @ joint.hinge").empty());
}

}  // namespace
}  // namespace lacuna
