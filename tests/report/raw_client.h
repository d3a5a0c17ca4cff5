#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace lacuna {

/// A client of 127.0.0.1 that sends bytes as they stand, which no HTTP library would.
class RawClient {
 public:
  explicit RawClient(int port);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool is_connected() const { return socket_ >= 0; }
  /// False: the server has closed.
  bool send(std::string_view bytes) const;
  /// All that comes until the server closes; none: it does not within that time.
  std::optional<std::string> read_all(std::chrono::milliseconds longest = std::chrono::seconds(10)) const;
  void close();

 private:
  int socket_ = -1;
};

/// The number after "HTTP/1.1"; 0: there is none.
int status_of(const std::optional<std::string>& answer);

}  // namespace lacuna
