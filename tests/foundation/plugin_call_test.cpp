#include "foundation/plugins/plugin_call.h"

#include "foundation/processes/guarded_call.h"
#include "foundation/parallel.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PluginCall, IsActiveWhileItLivesAndRestoresTheOneBefore) {
  const char* const drag = component_on_page("effect \"drag\"");
  const char* const rig = component_on_page("target \"rig\"");
  EXPECT_THAT(CallPage::active(), IsEmpty());
  {
    PluginCall outer(rig, "carrying a test out");
    {
      const HostCall service;
      EXPECT_THAT(CallPage::active(), IsEmpty());
      const PluginCall inner(drag, "add_loads");
      EXPECT_THAT(CallPage::active(), ElementsAre(ActiveCall{"effect \"drag\"", "add_loads"}));
    }
    EXPECT_THAT(CallPage::active(), ElementsAre(ActiveCall{"target \"rig\"", "carrying a test out"}));
    outer.enter(rig, "recorded");
    EXPECT_THAT(CallPage::active(), ElementsAre(ActiveCall{"target \"rig\"", "recorded"}));
  }
  EXPECT_THAT(CallPage::active(), IsEmpty());
}

TEST(PluginCall, OfAGuardedCallEndsWithAnException) {
  const ComponentOrigin origin{"effect", "drag", "/opt/drag.so"};
  std::vector<ActiveCall> seen;
  EXPECT_ANY_THROW(guarded_call(origin, "amend", [&] {
    seen = CallPage::active();
    throw std::runtime_error("no");
  }));
  EXPECT_THAT(seen, ElementsAre(ActiveCall{"effect \"drag\" (/opt/drag.so)", "amend"}));
  EXPECT_THAT(CallPage::active(), IsEmpty());
}

TEST(PluginCall, EachThreadHasASlotAndGivesItBack) {
  constexpr std::size_t kMoreThanThereAreSlots = 3000;
  const char* const drag = component_on_page("effect \"drag\"");
  for (std::size_t round = 0; round < kMoreThanThereAreSlots / 2; ++round)
    parallel_for(2, 2, [&](std::size_t, int) {
      const PluginCall call(drag, "add_loads");
      EXPECT_THAT(CallPage::active(), ElementsAre(ActiveCall{"effect \"drag\"", "add_loads"}));
    });
  EXPECT_THAT(CallPage::active(), IsEmpty());
}

TEST(Evaluation, IsSeenByOthersWhileItLives) {
  EXPECT_THAT(CallPage::busy(), IsEmpty());
  const Evaluation outer;
  const std::vector<BusyThread> begun = CallPage::busy();
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_TRUE(begun[0].evaluates);
  EXPECT_TRUE(CallPage::call_of(*begun[0].slot).component.empty()) << "no plugin is called";
  { const Evaluation inner; }
  const std::vector<BusyThread> later = CallPage::busy();
  ASSERT_EQ(later.size(), 1U);
  EXPECT_TRUE(later[0].evaluates);
  EXPECT_NE(later[0].ticks, begun[0].ticks) << "an evaluation inside it has ended";
  const PluginCall call(component_on_page("effect \"drag\""), "add_loads");
  EXPECT_EQ(CallPage::call_of(*later[0].slot), (ActiveCall{"effect \"drag\"", "add_loads"}));
}

TEST(ComponentOnPage, EqualTextsHaveOnePlace) {
  EXPECT_EQ(component_on_page("metric \"mean\""), component_on_page(std::string("metric ") + "\"mean\""));
  EXPECT_STREQ(component_on_page("metric \"mean\""), "metric \"mean\"");
}

}  // namespace
}  // namespace lacuna
