#include "bad_plugins/bad_folder.h"
#include "loading/plugin_catalog.h"
#include "support/sanitizers.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

/// Effects whose hooks do what they must not: found where the plugins are loaded, before a model has them.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

class IllBehavedEffect : public testing::Test {
 protected:
  PluginListing listing(const std::string& name) const {
    for (const PluginListing& found : catalog_.list())
      if (found.name == name) return found;
    return {};
  }
  /// Expects that it is refused with these words.
  void expect_refusal(const std::string& name, const std::string& words) const {
    EXPECT_THAT([&] { catalog_.get<PhysicalEffect>(name); },
                ThrowsMessage<Error>(AllOf(HasSubstr("effect \"" + name + "\""), HasSubstr("ill_behaved.so"),
                                           HasSubstr(words), HasSubstr("this is a fault of the plugin"))));
  }

  BadFolder folder_{"ill_behaved"};
  PluginCatalog catalog_{{folder_.path()}};
};

TEST_F(IllBehavedEffect, ThatReplacesTheListOfLoadsIsRefused) {
  expect_refusal("replaces_the_list", "add_loads replaces the list of loads");
}

TEST_F(IllBehavedEffect, ThatOverwritesLoadsOfOthersIsRefused) {
  expect_refusal("overwrites_others", "add_loads overwrites loads that other effects have added");
}

TEST_F(IllBehavedEffect, ThatReadsBeyondItsParametersIsRefused) {
  expect_refusal("reads_beyond", "add_loads reads beyond its parameters (it has 1)");
  expect_refusal("amends_from_beyond", "amend reads beyond its parameters (it has 1)");
}

TEST_F(IllBehavedEffect, ThatWritesBeyondItsStateIsRefused) { expect_refusal("writes_beyond", "beyond its state"); }

TEST_F(IllBehavedEffect, ThatChangesTheArithmeticIsRefused) {
  expect_refusal("rounds", "add_loads changed the rounding of floating-point numbers");
}

TEST_F(IllBehavedEffect, ThatAllocatesInAStepWorksAndIsNamed) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer has its own allocator, whose calls are not counted";
  EXPECT_NO_THROW(catalog_.get<PhysicalEffect>("allocates"));
  EXPECT_THAT(listing("allocates").problem, IsEmpty());
  EXPECT_THAT(listing("allocates").remark,
              AllOf(HasSubstr("effect \"allocates\""), HasSubstr("add_loads allocates memory (once per call)")));
}

TEST_F(IllBehavedEffect, NothingIsSaidOfOneThatDoesWhatIsAllowed) {
  EXPECT_THAT(listing("sound").problem, IsEmpty());
  EXPECT_THAT(listing("sound").remark, IsEmpty());
}

TEST(EffectsOfTheBuild, AreWellBehaved) {
  for (const PluginListing& listing : PluginCatalog({built_plugins()}).list()) {
    EXPECT_THAT(listing.problem, IsEmpty());
    EXPECT_THAT(listing.remark, IsEmpty());
  }
}

}  // namespace
}  // namespace lacuna
