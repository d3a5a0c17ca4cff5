#include "app/mcp/message_lines.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace lacuna {

/// Whether there may be more in `received_` than before.
bool MessageLines::read_some(int milliseconds) {
  pollfd waiting{descriptor_, POLLIN, 0};
  const int ready = poll(&waiting, 1, milliseconds);
  if (ready == 0 || (ready < 0 && errno == EINTR)) return false;
  std::array<char, 1 << 16> block;
  const ssize_t count = ready < 0 ? -1 : read(descriptor_, block.data(), block.size());
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return false;
  if (count < 0) throw Error(fmt::format("standard input cannot be read: {}", strerror(errno)));
  ended_ = count == 0;
  received_.append(block.data(), static_cast<std::size_t>(count));
  return true;
}

MessageLines::Got MessageLines::take(std::string& line) {
  const std::size_t at = received_.find('\n', searched_);
  const bool whole = at != std::string::npos;
  searched_ = whole ? 0 : received_.size();
  if (!whole && !ended_ && received_.size() <= longest_ && !skipping_) return Got::nothing;
  const bool was_skipping = skipping_;
  const bool too_long = (whole ? at : received_.size()) > longest_;
  skipping_ = !whole && !ended_ && (skipping_ || too_long);
  line = received_.substr(0, whole ? at : received_.size());
  received_.erase(0, whole ? at + 1 : received_.size());
  if (received_.empty()) searched_ = 0;
  if (was_skipping) return Got::nothing;
  if (too_long) return Got::too_long;
  if (!whole && line.empty()) return Got::nothing;
  return Got::line;
}

MessageLines::Got MessageLines::next(std::string& line, int milliseconds) {
  if (const Got got = take(line); got != Got::nothing) return got;
  if (ended_ && received_.empty()) return Got::end;
  if (!ended_ && read_some(milliseconds)) return take(line);
  return Got::nothing;
}

}  // namespace lacuna
