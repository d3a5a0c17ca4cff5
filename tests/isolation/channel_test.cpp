#include "isolation/channel.h"

#include <gmock/gmock.h>

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace lacuna {
namespace {

std::pair<MessageChannel, MessageChannel> channels() {
  std::array<int, 2> ends{};
  EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
  return {MessageChannel(ends[0]), MessageChannel(ends[1])};
}

TEST(MessageChannel, CarriesMessagesOfAnySize) {
  const std::pair<MessageChannel, MessageChannel> ends = channels();
  const MessageChannel &here = ends.first, &there = ends.second;
  const std::string large(std::size_t{1} << 22, 'x');  // more than a socket takes at once
  std::thread sender([&] {
    for (const std::string& message : {std::string("one"), std::string(), large}) EXPECT_TRUE(here.send(message));
  });
  EXPECT_EQ(there.receive(), "one");
  EXPECT_EQ(there.receive(), "");
  EXPECT_EQ(there.receive(), large);
  sender.join();
}

TEST(MessageChannel, ASizeThatIsNotKeptTakesNoMemory) {
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
  const MessageChannel here(ends[0]);
  const std::string size_and_more(20, '\x7f');
  EXPECT_EQ(write(ends[1], size_and_more.data(), size_and_more.size()), 20);
  close(ends[1]);
  EXPECT_EQ(here.receive(), std::nullopt);
}

TEST(MessageChannel, ThatTheOtherEndClosedSaysSo) {
  auto [here, there] = channels();
  { const MessageChannel closed(std::move(there)); }
  EXPECT_EQ(here.receive(), std::nullopt);
  EXPECT_FALSE(here.send("hello?"));
}

}  // namespace
}  // namespace lacuna
