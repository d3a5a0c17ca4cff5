#include "dirty/dirty_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

/// Least and largest of a number over the rigs of a set.
struct Range {
  double least = 1e300, most = -1e300;
  void add(double value) { least = std::min(least, value), most = std::max(most, value); }
};

struct Ranges {
  Range mass, samples, duration, frequency, files, strength;
};

Ranges ranges_of(const std::string& set) {
  Ranges ranges;
  for (const DirtyPlan& plan : plan_dirty_cases(set)) {
    const DirtyRig rig = draw_rig(plan);
    const double samples = static_cast<double>(rig.trials.front().samples);
    ranges.mass.add(mass_of(rig));
    ranges.samples.add(samples);
    ranges.duration.add(samples * rig.interval);
    ranges.frequency.add(1.0 / rig.interval);
    ranges.files.add(static_cast<double>(rig.trials.size()));
    if (plan.mains > 0) ranges.strength.add(plan.strength);
  }
  return ranges;
}

TEST(DirtyPlan, HasItsNumbersOfCases) {
  EXPECT_EQ(plan_dirty_cases("dirty-tuning").size(), 300U);
  EXPECT_EQ(plan_dirty_cases("dirty-reporting").size(), 300U);
  EXPECT_EQ(plan_dirty_cases("dirty-quick").size(), 60U);
  EXPECT_EQ(plan_dirty_cases("dirty-values").size(), 40U);
  EXPECT_EQ(plan_dirty_cases("dirty-loops").size(), 30U);
  EXPECT_EQ(plan_dirty_cases("dirty-withheld").size(), 80U);
  EXPECT_THROW(plan_dirty_cases("tuning"), std::invalid_argument);
}

TEST(DirtyPlan, SetsShareNoSeed) {
  std::set<std::uint64_t> seeds;
  for (const char* set : {"dirty-tuning", "dirty-reporting", "dirty-quick"})
    for (const DirtyPlan& plan : plan_dirty_cases(set)) seeds.insert(plan.seed);
  EXPECT_EQ(seeds.size(), 660U);
}

TEST(DirtyPlan, BalancesFamiliesAndMainEffects) {
  std::map<std::string, int> families_met;
  std::map<int, int> mains;
  int gross = 0;
  for (const DirtyPlan& plan : plan_dirty_cases("dirty-quick")) {
    ++families_met[plan.family];
    ++mains[plan.mains];
    gross += plan.gross ? 1 : 0;
  }
  EXPECT_EQ(families_met.size(), families().size());
  for (const auto& [family, count] : families_met) EXPECT_EQ(count, 4) << family;
  EXPECT_EQ(mains[0], 12);
  EXPECT_EQ(mains[2], 15);
  EXPECT_EQ(gross, 6);
}

TEST(DirtyPlan, MeetsTheRangesOfRealRigs) {
  for (const char* set : {"dirty-tuning", "dirty-reporting", "dirty-quick"}) {
    const Ranges ranges = ranges_of(set);
    EXPECT_GE(ranges.mass.least, 0.01) << set;
    EXPECT_LE(ranges.mass.least, 0.025) << set;
    EXPECT_GE(ranges.mass.most, 50.0) << set;
    EXPECT_LE(ranges.mass.most, 130.0) << set;
    EXPECT_GE(ranges.samples.least, 25.0) << set;
    EXPECT_LE(ranges.samples.least, 35.0) << set;
    EXPECT_LE(ranges.duration.most, 120.1) << set;
    EXPECT_GE(ranges.duration.most, 100.0) << set;
    EXPECT_GE(ranges.frequency.least, 15.0 - 1e-9) << set;
    EXPECT_LE(ranges.frequency.least, 16.0) << set;
    EXPECT_LE(ranges.frequency.most, 2000.0 + 1e-9) << set;
    EXPECT_GE(ranges.frequency.most, 1500.0) << set;
    EXPECT_EQ(ranges.files.least, 1.0) << set;
    EXPECT_EQ(ranges.files.most, 3.0) << set;
    EXPECT_LE(ranges.strength.least, 4.0) << set;
    EXPECT_GE(ranges.strength.most, 60.0) << set;
  }
}

TEST(DirtyPlan, WithholdsHalfOfTheLawsEachUnderRandomForcesAndNot) {
  std::map<std::pair<bool, bool>, int> met;
  for (const DirtyPlan& plan : plan_dirty_cases("dirty-withheld")) ++met[{plan.withheld, plan.disturbance > 0.0}];
  ASSERT_EQ(met.size(), 4U);
  for (const auto& [kind, count] : met) EXPECT_EQ(count, 20) << kind.first << kind.second;
}

TEST(DirtyPlan, DrawsTheSameRigFromTheSameSeed) {
  for (const DirtyPlan& plan : plan_dirty_cases("dirty-quick")) {
    const DirtyRig first = draw_rig(plan), second = draw_rig(plan);
    EXPECT_EQ(mass_of(first), mass_of(second));
    ASSERT_EQ(first.trials.size(), second.trials.size());
    EXPECT_EQ(first.trials.back().reference, second.trials.back().reference);
  }
}

}  // namespace
}  // namespace hidden_effects::dirty
