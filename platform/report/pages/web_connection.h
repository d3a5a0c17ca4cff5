#pragma once

#include "report/pages/web_server.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/ip/tcp.hpp>

#include <list>

namespace lacuna {

/// Of the one executor that there is, which is compiled faster than any.
using WebSocket = boost::asio::basic_stream_socket<boost::asio::ip::tcp, boost::asio::io_context::executor_type>;

/// The open connections of a server, all of one thread.
class WebConnections {
 public:
  using Handler = std::function<void(WebRequest, WebReply)>;
  WebConnections(const Handler& handle, const WebLimits& limits) : handle_(handle), limits_(limits) {}

  /// Begins to read.
  void add(WebSocket socket);
  /// Whether one more may be added, after one that the limits do not protect has made room.
  bool has_room() { return open_.size() < limits_.connections || make_room(limits_.patience); }
  /// Closes the oldest connection that was answered, or whose request has not arrived, or whose answer is being taken
  /// slowly, for `patience` at least. False: all are protected, or wait for their answers.
  bool make_room(std::chrono::milliseconds patience);

 private:
  friend class WebConnection;
  void remove(const WebConnection& connection);
  const Handler& handle_;
  const WebLimits& limits_;
  std::list<std::shared_ptr<WebConnection>> open_;  // shared: with operations under way; the oldest first
  std::size_t bytes_under_way_ = 0;                 ///< of answers
};

}  // namespace lacuna
