#include "app/mcp/message_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr std::size_t kLongest = 10;

/// A pipe with these pieces in it, and what comes out until its end.
class MessageLinesTest : public testing::Test {
 protected:
  MessageLinesTest() { EXPECT_EQ(pipe(ends_.data()), 0); }
  ~MessageLinesTest() override { close(ends_[0]); }

  std::vector<std::string> lines_of_input(const std::string& input) {
    EXPECT_EQ(write(ends_[1], input.data(), input.size()), static_cast<ssize_t>(input.size()));
    close(ends_[1]);
    MessageLines lines(ends_[0], kLongest);
    std::vector<std::string> found;
    std::string line;
    for (MessageLines::Got got = lines.next(line, 0); got != MessageLines::Got::end; got = lines.next(line, 0)) {
      if (got == MessageLines::Got::line) found.push_back(line);
      if (got == MessageLines::Got::too_long) found.emplace_back("too long");
    }
    return found;
  }

  std::array<int, 2> ends_{};
};

TEST_F(MessageLinesTest, AreWhatStandsBetweenNewlines) {
  EXPECT_THAT(lines_of_input("one\n\ntwo\nthree"), testing::ElementsAre("one", "", "two", "three"));
}

TEST_F(MessageLinesTest, AreToldToBeTooLongOnceAndTheNextIsRead) {
  EXPECT_THAT(lines_of_input("0123456789\n0123456789a\nnext\n" + std::string(50000, 'x') + "\nlast\n"),
              testing::ElementsAre("0123456789", "too long", "next", "too long", "last"));
}

TEST_F(MessageLinesTest, EndWithTheInput) { EXPECT_THAT(lines_of_input(""), testing::IsEmpty()); }

TEST_F(MessageLinesTest, MayComeInPieces) {
  MessageLines lines(ends_[0], kLongest);
  std::string line;
  ASSERT_EQ(write(ends_[1], "ab", 2), 2);
  EXPECT_EQ(lines.next(line, 0), MessageLines::Got::nothing);
  ASSERT_EQ(write(ends_[1], "c\nd", 3), 3);
  EXPECT_EQ(lines.next(line, 0), MessageLines::Got::line);
  EXPECT_EQ(line, "abc");
  close(ends_[1]);
}

}  // namespace
}  // namespace lacuna
