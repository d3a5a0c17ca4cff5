#include "loading/plugin_catalog.h"

#include "foundation/digest.h"
#include "loading/built_plugins.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <stdlib.h>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

TEST(PluginCatalog, FindsTheComponentsOfTheBuild) {
  const PluginCatalog catalog({built_plugins()});
  EXPECT_THAT(catalog.problems(), IsEmpty());
  EXPECT_THAT(catalog.get<PhysicalEffect>("coulomb_friction").describe().equation, HasSubstr("torque*sgn(v)"));
}

TEST(PluginCatalog, MakesAComponentOnce) {
  const PluginCatalog catalog({built_plugins()});
  EXPECT_EQ(&catalog.get<PhysicalEffect>("coulomb_friction"), &catalog.get<PhysicalEffect>("coulomb_friction"));
}

TEST(PluginCatalog, ComponentsOutliveTheCatalog) {
  const PhysicalEffect* effect = nullptr;
  {
    const PluginCatalog catalog({built_plugins()});
    effect = &catalog.get<PhysicalEffect>("coulomb_friction");
  }
  EXPECT_EQ(effect->describe().parameters.front().name, "torque");
}

TEST(PluginCatalog, RecordsTheDigestOfEachFile) {
  const std::string digest = sha256_of_file(built_plugins() / "coulomb_friction.so");
  EXPECT_THAT(PluginCatalog({built_plugins()}).list(), Contains(Field(&PluginListing::sha256, digest)));
}

TEST(PluginCatalog, AMissingNameBringsTheNearestOneAndTheFolders) {
  const PluginCatalog catalog({built_plugins()});
  EXPECT_THAT(
      [&] { catalog.get<PhysicalEffect>("coulomb_fricton"); },
      ThrowsMessage<Error>(AllOf(HasSubstr("no effect \"coulomb_fricton\""),
                                 HasSubstr("did you mean \"coulomb_friction\""), HasSubstr(built_plugins().string()))));
}

TEST(PluginCatalog, TheSameFileThroughTwoSpellingsIsOneFile) {
  const TestFolder folder;
  std::filesystem::create_directory_symlink(built_plugins(), folder.path() / "link");
  const PluginCatalog catalog({built_plugins(), built_plugins() / "." / "", folder.path() / "link"});
  EXPECT_THAT(catalog.problems(), IsEmpty());
}

TEST(PluginCatalog, AFolderThatDoesNotExistIsPassedOver) {
  const PluginCatalog catalog({"/nowhere/at/all", built_plugins()});
  EXPECT_THAT(catalog.problems(), IsEmpty());
}

TEST(PluginSearchPath, CommandLineThenVariableThenTheProgramsOwn) {
  setenv("LACUNA_PLUGIN_PATH", "/a:/b", 1);
  const std::vector<std::filesystem::path> path = plugin_search_path({"/first"});
  unsetenv("LACUNA_PLUGIN_PATH");
  EXPECT_THAT(path, testing::ElementsAre("/first", "/a", "/b", built_plugins()));
}

}  // namespace
}  // namespace lacuna
