#include "isolation/channel.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <utility>

namespace lacuna {
namespace {

constexpr int kBetweenLooks = 50;            // ms
constexpr std::uint64_t kBlock = 1U << 24U;  // bytes; memory for a stated size is taken only as its bytes arrive

}  // namespace

MessageChannel::~MessageChannel() {
  if (descriptor_ >= 0) close(descriptor_);
}

MessageChannel::MessageChannel(MessageChannel&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), stop_(other.stop_) {}

bool MessageChannel::send(const std::string& message) const {
  const auto size = static_cast<std::uint64_t>(message.size());
  std::string framed(reinterpret_cast<const char*>(&size), sizeof(size));
  framed += message;
  for (std::size_t done = 0; done < framed.size();) {
    const ssize_t sent = ::send(descriptor_, framed.data() + done, framed.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    done += static_cast<std::size_t>(sent);
  }
  return true;
}

bool MessageChannel::read_all(char* bytes, std::size_t count) const {
  while (count > 0) {
    pollfd waiting{descriptor_, POLLIN, 0};
    const int ready = poll(&waiting, 1, kBetweenLooks);
    stop_.throw_if_kept_waiting();
    if (ready <= 0) continue;
    const ssize_t got = read(descriptor_, bytes, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

std::optional<std::string> MessageChannel::receive() const {
  std::uint64_t size = 0;
  if (!read_all(reinterpret_cast<char*>(&size), sizeof(size))) return std::nullopt;
  std::string message;
  while (message.size() < size) {
    const std::size_t done = message.size();
    message.resize(done + static_cast<std::size_t>(std::min(size - done, kBlock)));
    if (!read_all(message.data() + done, message.size() - done)) return std::nullopt;
  }
  return message;
}

}  // namespace lacuna
