#include "foundation/files/whole_file.h"

#include <lacuna/error.h>

#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

namespace lacuna {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class WholeFileTest : public testing::Test {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
      found.push_back(entry.path().filename());
    return found;
  }

  const TestFolder folder_;
  const fs::path file_ = folder_.write("result.json", "old\n");
};

TEST_F(WholeFileTest, ReplacesAFileAndKeepsItsPermissions) {
  fs::permissions(file_, fs::perms(0640));
  write_whole(file_, "new\n", Link::followed);
  EXPECT_EQ(read_bytes(file_), "new\n");
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms(0640));
  EXPECT_THAT(names(), testing::ElementsAre("result.json"));
}

TEST_F(WholeFileTest, MakesAFileWithTheUsualPermissions) {
  const mode_t before = ::umask(027);
  write_whole(folder_ / "fresh.json", "new\n", Link::replaced);
  ::umask(before);
  EXPECT_EQ(fs::status(folder_ / "fresh.json").permissions(), fs::perms(0640));
}

TEST_F(WholeFileTest, KeepsTheOldFileUntilTheNewOneIsWhole) {
  WholeFile whole(file_, Link::followed);
  whole.stream() << std::string(1 << 20, 'x') << std::flush;
  EXPECT_EQ(read_bytes(file_), "old\n");
  whole.publish();
  EXPECT_EQ(fs::file_size(file_), 1U << 20);
}

TEST_F(WholeFileTest, KeepsTheOldFileWhereTheWorkEndsByAnException) {
  try {
    WholeFile whole(file_, Link::followed);
    whole.stream() << "half of it" << std::flush;
    throw std::runtime_error("the query failed");
  } catch (const std::runtime_error&) {
    EXPECT_EQ(read_bytes(file_), "old\n");
    EXPECT_THAT(names(), testing::ElementsAre("result.json"));
  }
}

/// A disk that is full, as a limit on the size of files, which a process can set for itself alone.
TEST_F(WholeFileTest, KeepsTheOldFileOnAFullDisk) {
  const auto write_much = [this] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_whole(file_, std::string(1 << 20, 'x'), Link::followed);
    } catch (const Error& error) {
      std::fputs(error.what(), stderr);
      ::_exit(3);
    }
    ::_exit(0);
  };
  EXPECT_EXIT(write_much(), testing::ExitedWithCode(3), "result.json: cannot be written completely");
  EXPECT_EQ(read_bytes(file_), "old\n");
  EXPECT_THAT(names(), testing::ElementsAre("result.json"));
}

TEST_F(WholeFileTest, LeavesNoDraftWhenKilled) {
  std::array<int, 2> ready{};
  ASSERT_EQ(::pipe(ready.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    WholeFile whole(file_, Link::followed);
    whole.stream() << "half of it" << std::flush;
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(0);
  }
  char begun = 0;
  ASSERT_EQ(::read(ready[0], &begun, 1), 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ready[0]);
  ::close(ready[1]);
  EXPECT_EQ(read_bytes(file_), "old\n");
  const int unnamed = ::open(folder_.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (unnamed < 0) GTEST_SKIP() << "this file system has no files without a name";
  ::close(unnamed);
  EXPECT_THAT(names(), testing::ElementsAre("result.json"));
}

TEST_F(WholeFileTest, RemovesDraftsOfTheKilledAndNoOthers) {
  const std::string own = [&] {  // what names of this machine's drafts begin with
    const std::string name = WholeFile(file_, Link::followed).named_draft().filename();
    return name.substr(0, std::string(".lacuna-").size() + 8);
  }();
  const auto hour_ago = fs::file_time_type::clock::now() - std::chrono::minutes(61);
  folder_.write(own + "01234567", "half of it");
  fs::last_write_time(folder_.write(own + "-01234567", "half of it"), hour_ago);
  folder_.write(own + "-89abcdef", "half of it, by a library that holds no lock of ours");
  folder_.write(".lacuna-0123456789abcdef", "half of it, of another machine, whose locks are not seen here");
  folder_.write(".lacuna-settings", "mine");
  const fs::path held = folder_.write(own + "76543210", "half of it");
  const int writer = ::open(held.c_str(), O_WRONLY);
  ASSERT_EQ(::flock(writer, LOCK_EX), 0);
  write_whole(file_, "new\n", Link::followed);
  EXPECT_THAT(names(), testing::UnorderedElementsAre("result.json", ".lacuna-settings", ".lacuna-0123456789abcdef",
                                                     own + "-89abcdef", own + "76543210"));
  ::close(writer);
}

/// What a library wrote when its process was killed.
TEST_F(WholeFileTest, RemovesANamedDraftAsSoonAsItsProcessHasEnded) {
  std::array<int, 2> ready{};
  ASSERT_EQ(::pipe(ready.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    WholeFile whole(file_, Link::followed);
    if (!whole.named_draft().empty() && ::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(0);
  }
  char begun = 0;
  ASSERT_EQ(::read(ready[0], &begun, 1), 1);
  write_whole(file_, "new\n", Link::followed);
  EXPECT_EQ(names().size(), 2U) << "the draft of a process that lives stays";
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ready[0]);
  ::close(ready[1]);
  EXPECT_EQ(names().size(), 2U);
  write_whole(file_, "newer\n", Link::followed);
  EXPECT_THAT(names(), testing::ElementsAre("result.json"));
}

/// As on a network file system, which takes flock for a lock of the whole file.
TEST_F(WholeFileTest, LeavesLockingToTheLibraryThatWritesTheDraft) {
  WholeFile whole(file_, Link::replaced);
  const int library = ::open(whole.named_draft().c_str(), O_RDWR);
  EXPECT_EQ(::flock(library, LOCK_EX | LOCK_NB), 0);
  ::close(library);
}

TEST_F(WholeFileTest, FollowsALinkThatTheUserNamed) {
  fs::create_symlink("result.json", folder_ / "link.json");  // from its own folder
  write_whole(folder_ / "link.json", "new\n", Link::followed);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.json"));
  EXPECT_EQ(read_bytes(file_), "new\n");
  fs::create_symlink(folder_ / "later.json", folder_ / "early.json");
  write_whole(folder_ / "early.json", "new\n", Link::followed);
  EXPECT_EQ(read_bytes(folder_ / "later.json"), "new\n");
}

TEST_F(WholeFileTest, RefusesLinksThatLeadInACircle) {
  fs::create_symlink("b.json", folder_ / "a.json");
  fs::create_symlink("a.json", folder_ / "b.json");
  EXPECT_THAT(why_not_writable(folder_ / "a.json"), testing::Optional(HasSubstr("symbolic links form a circle")));
  EXPECT_THAT([&] { write_whole(folder_ / "a.json", "new\n", Link::followed); },
              testing::ThrowsMessage<Error>(HasSubstr("a.json: cannot be written: its symbolic links")));
  EXPECT_TRUE(fs::is_symlink(folder_ / "a.json") && fs::is_symlink(folder_ / "b.json"));
}

TEST_F(WholeFileTest, TellsBeforehandWhatCannotBeWritten) {
  const auto says = [](const char* reason) { return testing::Optional(HasSubstr(reason)); };
  EXPECT_THAT(why_not_writable(folder_ / std::string(300, 'x')), says("File name too long"));
  EXPECT_THAT(why_not_writable("/proc/x"), says("folder /proc cannot be written to: "));
  EXPECT_THAT(why_not_writable("/proc/self/x"), says("No such file"));
  EXPECT_THAT(why_not_writable_into("/proc"), says("cannot be written to"));
  EXPECT_EQ(why_not_writable(file_), std::nullopt);
  EXPECT_EQ(why_not_writable(folder_ / "fresh.json"), std::nullopt);
  EXPECT_EQ(why_not_writable("/dev/null"), std::nullopt);
  EXPECT_THAT(names(), testing::ElementsAre("result.json"));
}

TEST_F(WholeFileTest, ReplacesALinkThatHasANameOfOurs) {
  fs::create_symlink(file_, folder_ / "angle.svg");
  write_whole(folder_ / "angle.svg", "new\n", Link::replaced);
  EXPECT_FALSE(fs::is_symlink(folder_ / "angle.svg"));
  EXPECT_EQ(read_bytes(folder_ / "angle.svg"), "new\n");
  EXPECT_EQ(read_bytes(file_), "old\n");
}

TEST_F(WholeFileTest, WritesDirectlyIntoWhatIsNoFile) {
  EXPECT_NO_THROW(write_whole("/dev/null", "new\n", Link::followed));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write_whole(pipe, "new\n", Link::followed);
  std::array<char, 8> text{};
  EXPECT_EQ(::read(reader, text.data(), text.size()), 4);
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(WholeFileTest, SaysWhenADeviceIsFull) {
  try {
    write_whole("/dev/full", "new\n", Link::followed);
    ADD_FAILURE() << "nothing was said";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/full: cannot be written completely"));
  }
}

/// What the shell has redirected standard output to is not replaced under it.
TEST_F(WholeFileTest, WritesBehindWhatADescriptorHas) {
  const int descriptor = ::open(file_.c_str(), O_WRONLY | O_APPEND);
  struct stat before {
  }, after{};
  ::fstat(descriptor, &before);
  write_whole("/dev/fd/" + std::to_string(descriptor), "new\n", Link::followed);
  ::stat(file_.c_str(), &after);
  ::close(descriptor);
  EXPECT_EQ(before.st_ino, after.st_ino);
  EXPECT_EQ(read_bytes(file_), "old\nnew\n");
}

TEST_F(WholeFileTest, PublishesAsNewOnlyWhereThereIsNothing) {
  WholeFile taken(file_, Link::replaced), fresh(folder_ / "fresh.json", Link::replaced);
  taken.stream() << "new\n";
  EXPECT_THROW(taken.publish_as_new(), Error);
  EXPECT_EQ(read_bytes(file_), "old\n");
  fresh.stream() << "new\n";
  fresh.publish_as_new();
  EXPECT_EQ(read_bytes(folder_ / "fresh.json"), "new\n");
}

TEST_F(WholeFileTest, TellsWhetherAFileWouldBeReplaced) {
  fs::create_symlink(file_, folder_ / "link");
  EXPECT_TRUE(is_replaceable(file_));
  EXPECT_TRUE(is_replaceable(folder_ / "link"));
  EXPECT_FALSE(is_replaceable(folder_ / "fresh.json"));
  EXPECT_FALSE(is_replaceable(folder_.path()));
  EXPECT_FALSE(is_replaceable("/dev/null"));
  EXPECT_THROW(write_whole(file_, "new\n", Link::followed, Existing::refused), Error);
  EXPECT_EQ(read_bytes(file_), "old\n");
  write_whole("/dev/null", "new\n", Link::followed, Existing::refused);
}

TEST_F(WholeFileTest, SaysWhereNothingCanBeWritten) {
  EXPECT_THROW(write_whole(folder_ / "no/such.json", "new\n", Link::followed), Error);
  EXPECT_THROW(write_whole(folder_.path(), "new\n", Link::followed), Error);
  EXPECT_THROW(write_whole(folder_.path(), "new\n", Link::replaced), Error);
}

}  // namespace
}  // namespace lacuna
