#include "bad_plugins/bad_folder.h"
#include "loading/plugin_catalog.h"

#include <gmock/gmock.h>

#include <stdlib.h>

#include <map>

/// Broken libraries: each gives one sentence that names the file and what to do, and the host goes on.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// Expects that a catalog with this file beside the sound ones has this one problem and the sound ones.
void expect_one_problem(const std::filesystem::path& folder, const std::string& file, const std::string& what,
                        const std::string& what_to_do) {
  const PluginCatalog catalog({built_plugins(), folder});
  EXPECT_THAT(catalog.problems(),
              ElementsAre(AllOf(HasSubstr((folder / file).string()), HasSubstr(what), HasSubstr(what_to_do))));
  EXPECT_EQ(catalog.get<PhysicalEffect>("viscous_friction").describe().parameters.size(), 1U);
}

TEST(BadPlugin, WithoutTheSymbol) {
  const BadFolder folder("missing_symbol");
  expect_one_problem(folder.path(), "missing_symbol.so", "has no function lacuna_plugin", "LACUNA_PLUGIN");
}

TEST(BadPlugin, WithAnUndefinedSymbolNamesItReadably) {
  const BadFolder folder("undefined_symbol");
  expect_one_problem(folder.path(), "undefined_symbol.so", "it calls rig::gear_ratio(int), which is defined nowhere",
                     "build it again");
}

TEST(BadPlugin, OfAnotherInterfaceVersion) {
  const BadFolder folder("other_version");
  expect_one_problem(folder.path(), "other_version.so", "version 0 of the plugin interface", "build it again");
}

TEST(BadPlugin, WithAnotherLayout) {
  const BadFolder folder("other_layout");
  expect_one_problem(folder.path(), "other_layout.so", "lays out", "build it again");
}

TEST(BadPlugin, ThatDiesOnLoadTakesOnlyAChildProcessWithIt) {
  const BadFolder folder("dies_on_load");
  expect_one_problem(folder.path(), "dies_on_load.so", "when it was loaded", "remove it from the folder");
}

TEST(BadPlugin, CutShort) {
  const std::string whole = read_bytes(built_plugins() / "viscous_friction.so");
  for (const double share : {0.1, 0.5, 0.9}) {
    const TestFolder folder;
    folder.write("cut.so", whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    expect_one_problem(folder.path(), "cut.so", "is incomplete", "copy it or build it again");
  }
}

TEST(BadPlugin, Empty) {
  const TestFolder folder;
  folder.write("empty.so", "");
  expect_one_problem(folder.path(), "empty.so", "not a shared library", "take it out");
}

TEST(BadPlugin, ThatIsText) {
  const TestFolder folder;
  folder.write("text.so", "not a library\n");
  expect_one_problem(folder.path(), "text.so", "not a shared library", "take it out");
}

TEST(BadPlugin, WithDamagedInsidesNeverEndsTheHost) {
  const std::string whole = read_bytes(built_plugins() / "viscous_friction.so");
  constexpr std::size_t kPieces = 24;
  const TestFolder folder;
  for (std::size_t i = 0; i < kPieces; ++i) {
    std::string damaged = whole;
    const std::size_t start = 64 + i * (whole.size() - 64) / kPieces;
    for (std::size_t at = start; at < std::min(start + 256, whole.size()); ++at) damaged[at] = '\x5a';
    folder.write("damaged_" + std::to_string(i) + ".so", damaged);
  }
  const PluginCatalog catalog({folder.path()});
  EXPECT_THAT(catalog.problems(), testing::Not(IsEmpty()));
}

TEST(BadPlugin, OfANameThatIsTakenNamesBothFiles) {
  const BadFolder folder("duplicate");
  const PluginCatalog catalog({built_plugins(), folder.path()});
  const auto names_both = AllOf(HasSubstr("two plugins have the effect \"coulomb_friction\""),
                                HasSubstr((built_plugins() / "coulomb_friction.so").string()),
                                HasSubstr((folder.path() / "duplicate.so").string()), HasSubstr("remove one of them"));
  EXPECT_THAT(catalog.problems(), ElementsAre(names_both));
  EXPECT_THAT([&] { catalog.get<PhysicalEffect>("coulomb_friction"); }, ThrowsMessage<Error>(names_both));
  EXPECT_NO_THROW(catalog.get<PhysicalEffect>("viscous_friction"));
}

TEST(BadPlugin, ThatIsAskedForBringsItsProblem) {
  const BadFolder folder("other_layout");
  const PluginCatalog catalog({folder.path()});
  EXPECT_THAT([&] { catalog.get<PhysicalEffect>("other_layout"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("no effect \"other_layout\""), HasSubstr("lays out"))));
}

TEST(BadPlugin, WhoseFactoryThrowsNamesComponentAndFile) {
  const BadFolder folder("throwing");
  const PluginCatalog catalog({folder.path()});
  EXPECT_THAT(catalog.problems(), IsEmpty());
  EXPECT_THAT([&] { catalog.get<PhysicalEffect>("throws_in_factory"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("effect \"throws_in_factory\""), HasSubstr("throwing.so"),
                                         HasSubstr("its factory threw std::runtime_error (no licence found)"),
                                         HasSubstr("repair it"))));
  EXPECT_THAT([&] { catalog.get<PhysicalEffect>("throws_foreign_in_factory"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("an object of type rig::Trouble"), HasSubstr("repair it"))));
  EXPECT_NO_THROW(catalog.get<PhysicalEffect>("harmless"));
}

TEST(BadPlugin, ThatSaysOfItselfWhatCannotBeIsRefusedByName) {
  const BadFolder folder("unfit");
  const PluginCatalog catalog({folder.path()});
  const auto refusal = [&](const char* name, const char* what) {
    return AllOf(HasSubstr(std::string("\"") + name + "\""), HasSubstr("unfit.so"), HasSubstr(what),
                 HasSubstr("repair it"));
  };
  const std::map<std::string, const char*> whats = {{"without_stage", "overrides `command` but names no stage"},
                                                    {"without_placement", "has no placement"},
                                                    {"unknown_unit", "\"{foo}\", which is not a unit for"},
                                                    {"bounds_reversed", "a lower bound above its upper bound"}};
  for (const auto& entry : whats)
    EXPECT_THAT([&] { catalog.get<PhysicalEffect>(entry.first); },
                ThrowsMessage<Error>(refusal(entry.first.c_str(), entry.second)));
  EXPECT_THAT([&] { catalog.get<FitnessMetric>("unknown_metric_unit"); },
              ThrowsMessage<Error>(refusal("unknown_metric_unit", "N*x")));
  for (const PluginListing& listing : catalog.list())
    EXPECT_EQ(listing.problem.empty(), listing.name == "undeclared_hook") << listing.problem;
  EXPECT_THAT(catalog.problems(), IsEmpty());
  EXPECT_TRUE(catalog.get<PhysicalEffect>("undeclared_hook").hooks().add_loads);
}

TEST(BadPlugin, ThatEndsTheProgramWhereItIsMadeOrDescribedTakesOnlyAChildProcessWithIt) {
  const BadFolder folder("hostile");
  for (const auto& [order, what] : {std::pair{"factory exit", "its factory ended the program with exit code 0"},
                                    std::pair{"describe _exit", "describe ended the program with exit code 0"},
                                    std::pair{"describe abort", "describe ended the program by signal 6"},
                                    std::pair{"stages segfault", "stages ended the program by signal 11"},
                                    std::pair{"stages terminate", "stages ended the program by signal 6"},
                                    std::pair{"describe kill", "describe ended the program by signal 9"}}) {
    setenv("HOSTILE", order, 1);
    const PluginCatalog catalog({folder.path()});
    unsetenv("HOSTILE");
    EXPECT_THAT([&] { catalog.get<PhysicalEffect>("hostile"); },
                ThrowsMessage<Error>(AllOf(HasSubstr("effect \"hostile\""), HasSubstr("hostile.so"), HasSubstr(what),
                                           HasSubstr("repair it"))));
    EXPECT_NO_THROW(catalog.get<PhysicalEffect>("harmless_neighbour"));
  }
}

TEST(BadPlugin, ThatCannotDescribeItselfIsListedWithItsProblem) {
  const BadFolder folder("throwing");
  for (const PluginListing& listing : PluginCatalog({folder.path()}).list()) {
    const bool faulty = listing.name == "throws_in_factory" || listing.name == "throws_foreign_in_factory" ||
                        listing.name == "throws_when_described";
    EXPECT_EQ(listing.problem.empty(), !faulty) << listing.name << ": " << listing.problem;
  }
}

}  // namespace
}  // namespace lacuna
