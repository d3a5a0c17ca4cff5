#pragma once

#include "foundation/processes/stop.h"

#include <optional>
#include <string>

namespace lacuna {

/// One end of a socket between two processes that send each other messages: a length and that many bytes.
class MessageChannel {
 public:
  /// Owns the descriptor. `stop` ends a wait for a message.
  explicit MessageChannel(int descriptor, const Stop& stop = {}) : descriptor_(descriptor), stop_(stop) {}
  ~MessageChannel();
  MessageChannel(MessageChannel&& other) noexcept;
  MessageChannel& operator=(MessageChannel&&) = delete;
  MessageChannel(const MessageChannel&) = delete;
  MessageChannel& operator=(const MessageChannel&) = delete;

  /// False: the other end is closed.
  bool send(const std::string& message) const;
  /// Nothing: the other end is closed. Throws `Interrupted` more than a second after a request to end.
  std::optional<std::string> receive() const;

 private:
  bool read_all(char* bytes, std::size_t count) const;

  int descriptor_;
  Stop stop_;
};

}  // namespace lacuna
