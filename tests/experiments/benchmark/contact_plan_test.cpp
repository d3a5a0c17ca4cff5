#include "contacts/contact_plan.h"

#include "contacts/contact_rig.h"

#include <gmock/gmock.h>

#include <map>

namespace hidden_effects {
namespace {

constexpr int kReporting = 60, kOfEachRig = 20, kNothing = 12;

TEST(ContactPlan, HasAsManyCasesOfEachRigAndHidesNothingInAFifth) {
  std::map<std::string, int> of_rig;
  int nothing = 0;
  for (const CasePlan& plan : plan_contact_cases("reporting", 0)) {
    ++of_rig[plan.rig];
    nothing += plan.hidden.empty() ? 1 : 0;
  }
  EXPECT_THAT(of_rig, testing::ElementsAre(std::pair("hopper", kOfEachRig), std::pair("quadruped", kOfEachRig),
                                           std::pair("wheeled_base", kOfEachRig)));
  EXPECT_EQ(nothing, kNothing);
}

TEST(ContactPlan, HidesEveryEffectOfARigOnceBeforeOneComesAgain) {
  for (const ContactRig& rig : contact_rigs()) {
    std::map<std::string, int> times;
    for (const CasePlan& plan : plan_contact_cases("reporting", 0))
      if (plan.rig == rig.name && !plan.hidden.empty()) ++times[plan.hidden.front().law];
    for (const ContactLaw& law : rig.laws)
      if (law.library_form()) {
        EXPECT_LE(times[law.name], 2) << rig.name << ' ' << law.name;
      }
  }
}

TEST(ContactPlan, StandsAfterTheOtherCasesOfItsSet) {
  const std::vector<CasePlan> planar = plan_cases("reporting"), all = plan_all_cases("reporting");
  ASSERT_EQ(all.size(), planar.size() + kReporting);
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k].number, static_cast<int>(k));
  for (std::size_t k = 0; k < planar.size(); ++k) EXPECT_EQ(all[k].seed, planar[k].seed);
  EXPECT_EQ(all[planar.size()].group, "contact");
}

}  // namespace
}  // namespace hidden_effects
