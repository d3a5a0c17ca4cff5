#include "bad_plugins/bad_folder.h"
#include "loading/plugin_catalog.h"
#include "support/sanitizers.h"

#include <gmock/gmock.h>

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cfenv>
#include <chrono>
#include <clocale>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

/// Libraries that change the process in which they are loaded or called, and files that are none: refused with a
/// sentence that says what they do, and the process is as it was.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// What the hostile plugin does (hostile.cpp), and how that is told.
const std::vector<std::pair<std::string, std::string>> kChanges = {
    {"fesetround", "the rounding of floating-point numbers"},
    {"flush_denormals", "the arithmetic near zero"},
    {"feenableexcept", "which floating-point errors raise a signal"},
    {"setlocale", "the locale (C.UTF-8"},
    {"chdir", "the current folder (/)"},
    {"umask", "the file mode mask (000)"},
    {"block_interrupts", "which signals are blocked"},
    {"ignore_interrupts", "what signals do (SIGINT)"},
    {"alarm", "a timer that raises a signal"},
    {"close_output", "the standard output (closed)"},
    {"set_terminate", "the handler of std::terminate"},
};

void expect_process_as_it_was(const std::filesystem::path& folder) {
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C");
  EXPECT_EQ(std::filesystem::current_path(), folder);
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_DFL);
  EXPECT_EQ(alarm(0), 0U);
  volatile double smallest = 4e-308;
  EXPECT_GT(smallest / 16.0, 0.0) << "denormal numbers count";
}

PluginCatalog catalog_with(const BadFolder& folder, const std::string& order) {
  setenv("HOSTILE", order.c_str(), 1);
  PluginCatalog catalog({built_plugins(), folder.path()});
  unsetenv("HOSTILE");
  return catalog;
}

TEST(HostileLibrary, ThatChangesTheProcessWhenItIsLoadedIsRefused) {
  const std::filesystem::path before = std::filesystem::current_path();
  for (const auto& [deed, words] : kChanges) {
    const BadFolder folder("hostile");
    const PluginCatalog catalog = catalog_with(folder, "load " + deed);
    EXPECT_THAT(catalog.problems(),
                ElementsAre(AllOf(HasSubstr((folder.path() / "hostile.so").string()), HasSubstr("changes " + words),
                                  HasSubstr("when it is loaded"), HasSubstr("remove the plugin from the folder"))))
        << deed;
    EXPECT_NO_THROW(catalog.get<PhysicalEffect>("viscous_friction")) << deed;
    expect_process_as_it_was(before);
  }
}

TEST(HostileLibrary, ThatChangesTheProcessInACallIsRefusedAndItsNeighbourIsNot) {
  const std::filesystem::path before = std::filesystem::current_path();
  for (const auto& [deed, words] : kChanges) {
    const BadFolder folder("hostile");
    const PluginCatalog catalog = catalog_with(folder, "describe " + deed);
    EXPECT_THAT([&] { catalog.get<PhysicalEffect>("hostile"); },
                ThrowsMessage<Error>(AllOf(HasSubstr("effect \"hostile\""), HasSubstr("hostile.so"),
                                           HasSubstr("describe changed " + words), HasSubstr("repair it"))))
        << deed;
    EXPECT_NO_THROW(catalog.get<PhysicalEffect>("harmless_neighbour")) << deed;
    expect_process_as_it_was(before);
  }
}

TEST(HostileLibrary, ThatChangesTheProcessOnlyInEarnestIsSetBackAndNamed) {
  if (LACUNA_WATCHED)
    GTEST_SKIP() << "a component that is refused once it is made is not destroyed, which counts as a leak";
  const std::filesystem::path before = std::filesystem::current_path();
  setenv("HOSTILE_LATER", "1", 1);
  for (const char* deed : {"fesetround", "flush_denormals", "feenableexcept", "setlocale"}) {
    const BadFolder folder("hostile");
    const std::string order = std::string("factory ") + deed;
    const PluginCatalog catalog = catalog_with(folder, order);
    setenv("HOSTILE", order.c_str(), 1);
    EXPECT_THAT([&] { catalog.get<PhysicalEffect>("hostile"); },
                ThrowsMessage<Error>(AllOf(HasSubstr("effect \"hostile\""), HasSubstr("its factory changed "))))
        << deed;
    unsetenv("HOSTILE");
    expect_process_as_it_was(before);
  }
  unsetenv("HOSTILE_LATER");
}

TEST(HostileLibrary, WhoseTableFunctionThrowsIsNamedAndTheOthersWork) {
  const BadFolder folder("hostile");
  const PluginCatalog catalog = catalog_with(folder, "lacuna_plugin throw");
  EXPECT_THAT(catalog.problems(),
              ElementsAre(AllOf(HasSubstr((folder.path() / "hostile.so").string() + ": lacuna_plugin threw an object"),
                                HasSubstr("fault of the plugin"))));
  EXPECT_NO_THROW(catalog.get<PhysicalEffect>("viscous_friction"));
}

TEST(HostileLibrary, ThatStopsTheProcessThatTriesItIsNamedAtOnce) {
  for (const auto& [order, words] :
       {std::pair{"load stop", "stopped the program by signal 19 (SIGSTOP) when it was loaded"},
        std::pair{"describe stop", "describe stopped the program by signal 19 (SIGSTOP)"}}) {
    const BadFolder folder("hostile");
    const auto begin = std::chrono::steady_clock::now();
    const PluginCatalog catalog = catalog_with(folder, order);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(9)) << "before its time is up";
    std::vector<std::string> problems = catalog.problems();
    for (const PluginListing& listing : catalog.list()) problems.push_back(listing.problem);
    EXPECT_THAT(problems, Contains(AllOf(HasSubstr("hostile.so"), HasSubstr(words)))) << order;
    EXPECT_NO_THROW(catalog.get<PhysicalEffect>("viscous_friction")) << order;
  }
}

TEST(HostileLibrary, WhoseInitialisersNeverEndIsLeftOut) {
  const BadFolder folder("hostile");
  const PluginCatalog catalog = catalog_with(folder, "load hang");
  EXPECT_THAT(catalog.problems(), ElementsAre(HasSubstr("hostile.so: took longer than 10 s when it was loaded")));
  EXPECT_NO_THROW(catalog.get<PhysicalEffect>("viscous_friction"));
}

/// Expects that a catalog of the folder, whose entry "odd.so" is no file of a library, says so and goes on.
void expect_refused_file(const std::filesystem::path& folder, const std::string& words) {
  const PluginCatalog catalog({built_plugins(), folder});
  EXPECT_THAT(catalog.problems(),
              ElementsAre(AllOf(HasSubstr((folder / "odd.so").string() + ": " + words), HasSubstr("plugin folder"))));
  EXPECT_NO_THROW(catalog.get<PhysicalEffect>("viscous_friction"));
}

TEST(PluginFolder, WithANamedPipeDoesNotWaitForItsWriter) {
  const TestFolder folder;
  ASSERT_EQ(mkfifo((folder.path() / "odd.so").c_str(), 0600), 0);
  expect_refused_file(folder.path(), "is a named pipe, not a shared library");
}

TEST(PluginFolder, WithAFolderADeviceOrALinkToNothingNamesThem) {
  {
    const TestFolder folder;
    std::filesystem::create_directory(folder.path() / "odd.so");
    expect_refused_file(folder.path(), "is a folder, not a shared library");
  }
  {
    const TestFolder folder;
    std::filesystem::create_symlink("/dev/zero", folder.path() / "odd.so");
    expect_refused_file(folder.path(), "is a device, not a shared library");
  }
  const TestFolder folder;
  std::filesystem::create_symlink("/nowhere/at/all.so", folder.path() / "odd.so");
  expect_refused_file(folder.path(), "is a link to a missing file");
}

}  // namespace
}  // namespace lacuna
