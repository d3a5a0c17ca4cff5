#include "evolution/operator_breeder.h"

#include <gmock/gmock.h>

#include <array>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

GenomeLayout two_genes() {
  GenomeLayout layout;
  layout.genes = {{"a", "1", GeneKind::real, 0.0, 10.0}, {"b", "1", GeneKind::integer, 0.0, 10.0}};
  return layout;
}

/// Adds one to the first gene.
class Increment : public MutationOperator {
 public:
  std::string summary() const override { return ""; }
  Genome vary(std::span<const Genome> parents, const GenomeLayout&, std::span<const double>,
              RandomStream&) const override {
    return {parents[0][0] + 1.0, parents[0][1]};
  }
};

/// The first gene of the child so far, the second of the other parent.
class Exchange : public MutationOperator {
 public:
  std::string summary() const override { return ""; }
  std::size_t parents() const override { return 2; }
  Genome vary(std::span<const Genome> parents, const GenomeLayout&, std::span<const double>,
              RandomStream&) const override {
    return {parents[0][0], parents[1][1]};
  }
};

class Thrower : public MutationOperator {
 public:
  std::string summary() const override { return ""; }
  Genome vary(std::span<const Genome>, const GenomeLayout&, std::span<const double>, RandomStream&) const override {
    throw 7;  // NOLINT: as a careless plugin does
  }
};

RandomStream stream(std::uint64_t seed) { return RandomStream(std::array<std::uint64_t, 1>{seed}); }

OperatorBreeder breeder(std::vector<AppliedMutation> mutations) {
  return {two_genes(), [](RandomStream&) { return Genome{0.0, 0.0}; }, std::move(mutations)};
}

TEST(OperatorBreeder, AppliesOperatorsInTheirOrderToOneParent) {
  const Increment increment;
  const OperatorBreeder twice = breeder({{&increment, {}, 1.0, {}}, {&increment, {}, 1.0, {}}});
  RandomStream random = stream(1);
  std::vector<std::size_t> used;
  const std::vector<Genome> parents = {{3.0, 4.0}};
  EXPECT_THAT(twice.child(parents, random, used), ElementsAre(5.0, 4.0));
  EXPECT_THAT(used, ElementsAre(0));
}

TEST(OperatorBreeder, AnOperatorIsAppliedAsOftenAsItsChanceSays) {
  const Increment increment;
  const OperatorBreeder sometimes = breeder({{&increment, {}, 0.25, {}}});
  const std::vector<Genome> parents = {{0.0, 0.0}};
  std::vector<std::size_t> used;
  int applied = 0;
  constexpr int kChildren = 4000;
  for (std::uint64_t i = 0; i < kChildren; ++i) {
    RandomStream random = stream(i);
    applied += sometimes.child(parents, random, used)[0] > 0.5 ? 1 : 0;
  }
  EXPECT_NEAR(applied, 0.25 * kChildren, 4 * 28);  // four standard deviations
}

TEST(OperatorBreeder, ACrossoverTakesAnotherParent) {
  const Exchange exchange;
  const OperatorBreeder crossed = breeder({{&exchange, {}, 1.0, {}}});
  const std::vector<Genome> parents = {{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}};
  std::vector<std::size_t> used;
  for (std::uint64_t i = 0; i < 100; ++i) {
    RandomStream random = stream(i);
    const Genome child = crossed.child(parents, random, used);
    ASSERT_EQ(used.size(), 2U);
    EXPECT_NE(used[0], used[1]);
    EXPECT_EQ(child[0], parents[used[0]][0]);
    EXPECT_EQ(child[1], parents[used[1]][1]);
  }
}

TEST(OperatorBreeder, ASingleParentIsCrossedWithItself) {
  const Exchange exchange;
  const std::vector<Genome> parents = {{3.0, 4.0}};
  RandomStream random = stream(1);
  std::vector<std::size_t> used;
  EXPECT_THAT(breeder({{&exchange, {}, 1.0, {}}}).child(parents, random, used), ElementsAre(3.0, 4.0));
}

TEST(OperatorBreeder, NamesAnOperatorThatLeavesTheBoundsOrThrows) {
  const Increment increment;
  const Thrower thrower;
  const std::vector<Genome> parents = {{10.0, 4.0}};
  RandomStream random = stream(1);
  std::vector<std::size_t> used;
  const ComponentOrigin origin{"mutation", "careless", "careless.so"};
  EXPECT_THAT(
      [&] {
        breeder({{&increment, {}, 1.0, origin}}).child(parents, random, used);
      },
      ThrowsMessage<Error>(AllOf(HasSubstr("careless.so"), HasSubstr("out of its bounds"))));
  EXPECT_THAT(
      [&] {
        breeder({{&thrower, {}, 1.0, origin}}).child(parents, random, used);
      },
      ThrowsMessage<Error>(AllOf(HasSubstr("careless.so"), HasSubstr("type int"))));
}

TEST(Misfit, SaysWhatDoesNotFit) {
  EXPECT_EQ(misfit({1.0, 2.0}, two_genes()), "");
  EXPECT_THAT(misfit({1.0}, two_genes()), HasSubstr("1 genes instead of 2"));
  EXPECT_THAT(misfit({1.0, 2.5}, two_genes()), HasSubstr("which is to be whole"));
  EXPECT_THAT(misfit({std::numeric_limits<double>::quiet_NaN(), 2.0}, two_genes()), HasSubstr("out of its bounds"));
}

}  // namespace
}  // namespace lacuna
