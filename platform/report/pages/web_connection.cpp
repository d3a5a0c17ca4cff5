#include "report/pages/web_connection.h"

#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/basic_stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <fmt/format.h>

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>

namespace lacuna {
namespace {

namespace http = boost::beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;
using Stream = boost::beast::basic_stream<tcp, boost::asio::io_context::executor_type>;

constexpr std::uint32_t kLongestHeader = 16'384;    ///< bytes
constexpr std::size_t kLongestBody = 1'000'000;     ///< bytes
constexpr std::size_t kLargestBuffer = 65'536;      ///< bytes of one read, also of what stands around chunks
constexpr std::size_t kMostUnderWay = 512'000'000;  ///< bytes of all answers that are being written
constexpr std::size_t kMostDrained = 8'000'000;     ///< bytes
constexpr auto kLongestFarewell = std::chrono::seconds(1);
constexpr auto kLongestWrite = std::chrono::seconds(30);  ///< and the time that a slow line takes
constexpr std::size_t kSlowLine = 100'000;                ///< bytes/s

WebRequest request_of(http::request<http::string_body>&& message) {
  WebRequest request;
  request.method = std::string(message.method_string());
  const std::string target(message.target());
  const std::size_t mark = target.find('?');
  request.path = target.substr(0, mark);
  if (mark != std::string::npos) request.query = target.substr(mark + 1);
  for (const auto& field : message) {
    std::string name(field.name_string());
    for (char& c : name)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    std::string& value = request.headers[name];
    value += (value.empty() ? "" : ", ") + std::string(field.value());
  }
  request.body = std::move(message.body());
  return request;
}

std::string head_of(const WebAnswer& answer) {
  const boost::beast::string_view reason =
      http::obsolete_reason(http::int_to_status(static_cast<unsigned>(answer.status)));
  return fmt::format(
      "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nConnection: close\r\nCache-Control: no-store\r\n"
      "X-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\nCross-Origin-Resource-Policy: same-origin\r\n"
      "Referrer-Policy: no-referrer\r\n{}\r\n",
      answer.status, std::string_view(reason.data(), reason.size()), answer.type, answer.text->size(),
      answer.status == 503 ? "Retry-After: 1\r\n" : "");
}

WebAnswer sentence(int status, const std::string& text) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>("lacuna serve: " + text + "\n")};
}

/// None: the client has gone.
std::optional<WebAnswer> answer_to(error_code fault) {
  if (fault == http::error::header_limit) return sentence(431, "the header is longer than 16 KB");
  if (fault == http::error::body_limit || fault == http::error::buffer_overflow)
    return sentence(413, "the request is longer than 1 MB");
  if (fault == http::error::end_of_stream || fault == http::error::partial_message) return std::nullopt;
  const bool is_syntax = fault.category() == http::make_error_code(http::error::bad_method).category();
  return is_syntax ? std::optional(sentence(400, "this is not an HTTP request: " + fault.message())) : std::nullopt;
}

}  // namespace

/// One connection: reads a request, waits for the answer, writes it, ends.
class WebConnection : public std::enable_shared_from_this<WebConnection> {
 public:
  using Clock = std::chrono::steady_clock;
  enum class State { reading, waiting, writing, leaving, closed };

  WebConnection(WebConnections& all, WebSocket socket);
  void read();
  void close();
  /// To make room for another one: a client that has no answer yet is told so.
  void dismiss();
  State state() const { return state_; }
  Clock::time_point since() const { return since_; }

  // For other threads.
  void answer_later(WebAnswer answer);
  bool is_gone() const { return gone_; }

 private:
  void handle_request();
  void refuse(error_code fault);
  void watch();
  void answer(WebAnswer answer);
  void write();
  void drain();
  void enter(State state);

  WebConnections& all_;
  Stream stream_;
  boost::beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  WebAnswer answer_;
  std::string head_;
  std::size_t drained_ = 0;
  State state_ = State::reading;
  Clock::time_point since_ = Clock::now();  ///< that it is in this state
  std::atomic<bool> gone_ = false;
};

void WebConnections::add(WebSocket socket) {
  const auto connection = std::make_shared<WebConnection>(*this, std::move(socket));
  open_.push_back(connection);
  connection->read();
}

bool WebConnections::make_room(std::chrono::milliseconds patience) {
  using State = WebConnection::State;
  const WebConnection::Clock::time_point latest = WebConnection::Clock::now() - patience;
  for (const State state : {State::leaving, State::reading, State::writing}) {
    const auto found = std::find_if(open_.begin(), open_.end(), [&](const auto& one) {
      return one->state() == state && (state == State::leaving || one->since() <= latest);
    });
    if (found == open_.end()) continue;
    const std::shared_ptr<WebConnection> oldest = *found;
    oldest->dismiss();
    return true;
  }
  return false;
}

void WebConnections::remove(const WebConnection& connection) {
  open_.remove_if([&](const auto& one) { return one.get() == &connection; });
}

WebConnection::WebConnection(WebConnections& all, WebSocket socket)
    : all_(all), stream_(std::move(socket)), buffer_(kLargestBuffer) {
  parser_.emplace();
  parser_->header_limit(kLongestHeader);
  parser_->body_limit(kLongestBody);
}

void WebConnection::read() {
  stream_.expires_after(all_.limits_.request);
  http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](error_code fault, std::size_t) {
    if (self->state_ != State::reading) return;
    if (fault) return self->refuse(fault);
    self->handle_request();
  });
}

void WebConnection::refuse(error_code fault) {
  std::optional<WebAnswer> told = answer_to(fault);
  if (!told) return close();
  enter(State::waiting);
  answer(std::move(*told));
}

void WebConnection::enter(State state) {
  if (state_ == State::writing) all_.bytes_under_way_ -= answer_.text->size();
  state_ = state;
  since_ = Clock::now();
}

void WebConnection::handle_request() {
  enter(State::waiting);
  stream_.expires_never();
  watch();
  WebRequest request = request_of(parser_->release());
  parser_.reset();
  try {
    all_.handle_(std::move(request), WebReply(shared_from_this()));
  } catch (const std::exception& error) {
    answer(sentence(500, error.what()));
  }
}

/// Sees a client that goes away while its answer is being found.
void WebConnection::watch() {
  stream_.socket().async_wait(tcp::socket::wait_read, [self = shared_from_this()](error_code fault) {
    if (fault || self->state_ != State::waiting) return;
    char next = 0;
    const ssize_t got = ::recv(self->stream_.socket().native_handle(), &next, 1, MSG_PEEK | MSG_DONTWAIT);
    if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) self->close();
  });
}

void WebConnection::answer_later(WebAnswer answer) {
  boost::asio::post(stream_.get_executor(), [self = shared_from_this(), answer = std::move(answer)]() mutable {
    self->answer(std::move(answer));
  });
}

void WebConnection::answer(WebAnswer answer) {
  if (state_ != State::waiting) return;  // gone, or answered before
  answer_ = std::move(answer);
  if (all_.bytes_under_way_ > 0 && all_.bytes_under_way_ + answer_.text->size() > kMostUnderWay)
    answer_ = sentence(503, "too many answers are being sent; try again later");
  all_.bytes_under_way_ += answer_.text->size();
  enter(State::writing);
  write();
}

void WebConnection::write() {
  const std::string& text = *answer_.text;
  head_ = head_of(answer_);
  stream_.expires_after(kLongestWrite + std::chrono::seconds(text.size() / kSlowLine));
  const std::array<boost::asio::const_buffer, 2> all = {boost::asio::buffer(head_), boost::asio::buffer(text)};
  boost::asio::async_write(stream_, all, [self = shared_from_this()](error_code fault, std::size_t) {
    if (fault || self->state_ != State::writing) return self->close();
    self->enter(State::leaving);
    self->answer_.text.reset();
    self->stream_.socket().shutdown(tcp::socket::shutdown_send, fault);
    self->stream_.expires_after(kLongestFarewell);
    self->drain();
  });
}

/// What a refused client is still sending is read for a moment: closing at once would take the answer from it.
void WebConnection::drain() {
  buffer_.clear();
  stream_.async_read_some(buffer_.prepare(kLargestBuffer),
                          [self = shared_from_this()](error_code fault, std::size_t size) {
                            self->drained_ += size;
                            if (fault || self->drained_ > kMostDrained || self->state_ == State::closed)
                              return self->close();
                            self->drain();
                          });
}

/// What its socket takes at once; unread bytes would take it away again.
void WebConnection::dismiss() {
  if (state_ == State::reading) {
    const WebAnswer busy = sentence(503, "too many clients are connected; try again later");
    const std::string told = head_of(busy) + *busy.text;
    const int socket = stream_.socket().native_handle();
    std::array<char, 4096> unread{};
    for (int more = 16; more > 0 && ::recv(socket, unread.data(), unread.size(), MSG_DONTWAIT) > 0;) --more;
    ::send(socket, told.data(), told.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  }
  close();
}

void WebConnection::close() {
  if (state_ == State::closed) return;
  enter(State::closed);
  gone_ = true;
  stream_.close();
  all_.remove(*this);
}

void WebReply::operator()(WebAnswer answer) const { connection_->answer_later(std::move(answer)); }
bool WebReply::is_wanted() const { return !connection_->is_gone(); }

std::string WebRequest::header(std::string_view name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? "" : found->second;
}

std::string WebRequest::parameter(std::string_view name) const {
  for (std::size_t begin = 0; begin <= query.size();) {
    const std::size_t end = std::min(query.find('&', begin), query.size());
    const std::string_view one = std::string_view(query).substr(begin, end - begin);
    if (one.size() > name.size() && one.starts_with(name) && one[name.size()] == '=')
      return std::string(one.substr(name.size() + 1));
    begin = end + 1;
  }
  return "";
}

}  // namespace lacuna
