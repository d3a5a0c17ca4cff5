#include "foundation/files/special_file.h"

#include "foundation/files/whole_file.h"
#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <fstream>
#include <string>

namespace lacuna {
namespace {

using testing::HasSubstr;

class SpecialFile : public testing::Test {
 protected:
  SpecialFile() { mkfifo(pipe_.c_str(), 0600); }
  TestFolder folder_;
  std::filesystem::path pipe_ = folder_.path() / "pipe";
};

TEST_F(SpecialFile, IsToldApartFromWhatIsMissing) {
  std::ofstream(folder_.path() / "file") << "text";
  EXPECT_EQ(why_no_regular_file(folder_.path() / "file"), "");
  EXPECT_EQ(why_no_regular_file(folder_.path() / "nothing"), "no such file");
  EXPECT_EQ(why_no_regular_file(folder_.path()), "is a folder, not a file");
  EXPECT_EQ(why_no_regular_file(pipe_), "is a pipe, not a regular file");
  EXPECT_EQ(why_no_regular_file("/dev/zero"), "is a device, not a regular file");
  sockaddr_un address{AF_UNIX, {}};
  const std::string socket_file = (folder_.path() / "socket").string();
  ASSERT_LT(socket_file.size(), sizeof(address.sun_path));
  std::memcpy(address.sun_path, socket_file.c_str(), socket_file.size());
  const int open = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(open, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_EQ(why_no_regular_file(socket_file), "is a socket, not a regular file");
  close(open);
}

TEST_F(SpecialFile, IsAnUnnamedPipeWhereAShellMakesOne) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  EXPECT_TRUE(is_unnamed_pipe("/dev/fd/" + std::to_string(ends[0])));
  EXPECT_FALSE(is_unnamed_pipe(pipe_)) << "opening it would wait for a writer";
  for (const int end : ends) close(end);
}

TEST_F(SpecialFile, APipeThatNobodyReadsTakesNoResults) {
  EXPECT_THAT(why_not_writable(pipe_).value_or("it can"), HasSubstr("a pipe without a reader; start its reader first"));
  EXPECT_THAT([&] { write_whole(pipe_, "text", Link::followed); },
              testing::ThrowsMessage<Error>(HasSubstr("a pipe without a reader")));
}

/// A reader sees the end of a pipe where the last who could write to it has closed it.
TEST_F(SpecialFile, APipeThatIsLookedAtKeepsItsReader) {
  const int reader = open(pipe_.c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_EQ(why_not_writable(pipe_), std::nullopt);
  std::array<char, 8> text{};
  EXPECT_EQ(read(reader, text.data(), text.size()), -1) << "nothing yet, and no end";
  EXPECT_EQ(errno, EAGAIN);
  close(reader);
}

}  // namespace
}  // namespace lacuna
