#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace lacuna {

/// A request that has arrived completely and within the limits.
struct WebRequest {
  std::string method, path, query, body;
  std::map<std::string, std::string, std::less<>> headers;  ///< by names in lower case; repeated ones joined by ", "

  /// Empty: it was not sent.
  std::string header(std::string_view name) const;
  /// Of the query part of the address, as it stands there. Empty: it is not there.
  std::string parameter(std::string_view name) const;
};

struct WebAnswer {
  int status = 200;
  const char* type = "application/json";
  std::shared_ptr<const std::string> text;  // shared: one text may be sent to several clients
};

class WebConnection;

/// Where the answer to one request goes, from any thread, once.
class WebReply {
 public:
  explicit WebReply(std::shared_ptr<WebConnection> connection) : connection_(std::move(connection)) {}
  void operator()(WebAnswer answer) const;
  /// False: the client has gone, nobody reads the answer.
  bool is_wanted() const;

 private:
  std::shared_ptr<WebConnection> connection_;  // shared: with the server, until one of them closes it
};

struct WebLimits {
  std::size_t connections = 128;              ///< open at once; more of them wait until they are accepted
  std::chrono::milliseconds patience{250};    ///< while others wait, for a request, and for taking an answer
  std::chrono::milliseconds request{10'000};  ///< from the beginning of a connection until its request is complete
};

struct WebServerOptions {
  std::string host;
  int port = 0;  ///< 0: the system chooses
  WebLimits limits = {};
  /// Called by the thread of `run`, which answers nobody else meanwhile: whatever takes longer than a look goes to
  /// another thread.
  std::function<void(WebRequest, WebReply)> handle;
};

/// An HTTP server that no client can keep from answering others. One thread serves all connections without waiting for
/// any of them. A request has to arrive whole within some seconds and some kilobytes of header and a megabyte of body,
/// chunked or not. Where too many connections are open, new ones wait their turn. So that they need not wait for a
/// client that does nothing, the oldest that has not sent its request makes room and is told to ask again later (503).
/// A connection ends with its answer.
class WebServer {
 public:
  /// Takes the port; throws `Error` where it is taken.
  explicit WebServer(WebServerOptions options);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  int port() const;
  /// Answers until `stop`, which another thread calls, before or after.
  void run();
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lacuna
