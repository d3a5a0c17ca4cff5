#include "report/pages/web_server.h"

#include "report/pages/web_connection.h"

#include <lacuna/error.h>

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>

namespace lacuna {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;
using Acceptor = boost::asio::basic_socket_acceptor<tcp, boost::asio::io_context::executor_type>;

constexpr auto kPauseAfterFault = std::chrono::milliseconds(50);  ///< no descriptors left, as a rule
constexpr auto kPauseWhileFull = std::chrono::milliseconds(5);

error_code listen(Acceptor& acceptor, const tcp::endpoint& at) {
  error_code fault;
  acceptor.open(at.protocol(), fault);
  if (!fault) acceptor.set_option(Acceptor::reuse_address(true), fault);
  if (!fault && at.protocol() == tcp::v6()) acceptor.set_option(boost::asio::ip::v6_only(false), fault);
  if (!fault) acceptor.bind(at, fault);
  if (!fault) acceptor.listen(boost::asio::socket_base::max_listen_connections, fault);
  if (fault) {
    error_code ignored;
    acceptor.close(ignored);
  }
  return fault;
}

/// At the first address of that name that can be listened at.
bool listen(Acceptor& acceptor, const std::string& host, int port) {
  error_code fault;
  boost::asio::ip::basic_resolver<tcp, boost::asio::io_context::executor_type> resolver(acceptor.get_executor());
  const auto found = resolver.resolve(host, std::to_string(port), tcp::resolver::passive, fault);
  if (fault) return false;
  for (const auto& entry : found)
    if (!listen(acceptor, entry.endpoint())) return true;
  return false;
}

std::string cannot_listen(boost::asio::io_context& io, const WebServerOptions& options) {
  Acceptor another(io);
  const bool host_is_at_fault = options.port == 0 || !listen(another, options.host, 0);
  if (host_is_at_fault)
    return fmt::format("{}: this machine cannot listen at this address; choose another with --host, or leave it out",
                       options.host);
  return fmt::format("{}: cannot listen at port {}; choose another with --port", options.host, options.port);
}

}  // namespace

struct WebServer::Impl {
  explicit Impl(WebServerOptions with) : options(std::move(with)), connections(options.handle, options.limits) {
    if (!listen(acceptor, options.host, options.port)) throw Error(cannot_listen(io, options));
    accept();
  }

  void accept() {
    if (!connections.has_room()) return accept_later(kPauseWhileFull);  // who comes now waits in the system's queue
    acceptor.async_accept([this](error_code fault, WebSocket socket) {
      if (fault == boost::asio::error::operation_aborted) return;
      if (fault) {
        connections.make_room({});
        return accept_later(kPauseAfterFault);
      }
      connections.add(std::move(socket));
      accept();
    });
  }

  void accept_later(std::chrono::milliseconds after) {
    pause.expires_after(after);
    pause.async_wait([this](error_code fault) {
      if (!fault) accept();
    });
  }

  const WebServerOptions options;
  boost::asio::io_context io{1};
  Acceptor acceptor{io};
  boost::asio::steady_timer pause{io};
  WebConnections connections;
};

WebServer::WebServer(WebServerOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
WebServer::~WebServer() = default;

int WebServer::port() const { return impl_->acceptor.local_endpoint().port(); }
void WebServer::run() { impl_->io.run(); }
void WebServer::stop() { impl_->io.stop(); }

}  // namespace lacuna
