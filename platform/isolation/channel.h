#pragma once

#include <optional>
#include <string>

namespace lacuna {

/// One end of a socket between two processes that send each other messages: a length and that many bytes.
class MessageChannel {
 public:
  /// Owns the descriptor.
  explicit MessageChannel(int descriptor) : descriptor_(descriptor) {}
  ~MessageChannel();
  MessageChannel(MessageChannel&& other) noexcept;
  MessageChannel& operator=(MessageChannel&&) = delete;
  MessageChannel(const MessageChannel&) = delete;
  MessageChannel& operator=(const MessageChannel&) = delete;

  /// False: the other end is closed.
  bool send(const std::string& message) const;
  /// Nothing: the other end is closed. Throws `Interrupted` where the user has asked twice to end.
  std::optional<std::string> receive() const;

 private:
  bool read_all(char* bytes, std::size_t count) const;

  int descriptor_;
};

}  // namespace lacuna
