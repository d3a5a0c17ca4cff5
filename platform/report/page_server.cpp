#include "report/page_server.h"

#include "report/base64.h"
#include "report/pages.h"
#include "report/processor_share.h"
#include "storage/page_query.h"
#include "storage/readable_database.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <sys/socket.h>

#include <cmath>
#include <ctime>
#include <map>
#include <mutex>

namespace lacuna {
namespace {

using PageJson = nlohmann::json;

using Text = std::shared_ptr<const std::string>;  ///< shared: an answer under way outlives the question

constexpr std::size_t kMostRows = 1'000'000;
constexpr int kThreads = 8;
constexpr std::size_t kLongestQuestion = 1'000'000;  ///< bytes

constexpr std::int64_t kLargestExact = std::int64_t{1} << 53;  ///< a page's numbers are double

/// Of what a user typed every value is told, as text where JSON has no such number; a page's own questions get null.
PageJson json_of(double number, bool typed) {
  if (std::isfinite(number)) return number;
  return typed ? PageJson(number > 0.0 ? "Infinity" : "-Infinity") : PageJson(nullptr);
}

PageJson json_of(const PageCell& cell, bool typed) {
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) {
    const bool exact = *integer <= kLargestExact && *integer >= -kLargestExact;
    return exact ? PageJson(*integer) : PageJson(std::to_string(*integer));
  }
  if (const auto* number = std::get_if<double>(&cell)) return json_of(*number, typed);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* bytes = std::get_if<std::vector<std::byte>>(&cell)) return {{"base64", base64(*bytes)}};
  if (const auto* blob = std::get_if<Blob>(&cell)) return {{"bytes", blob->bytes}};
  return nullptr;
}

/// Of this thread's work, s.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What this thread does until it ends, however it ends, is spent of a share.
class Spending {
 public:
  explicit Spending(ProcessorShare& share) : share_(share) {}
  ~Spending() { share_.spend(processor_seconds() - begin_); }
  Spending(const Spending&) = delete;
  Spending& operator=(const Spending&) = delete;

 private:
  ProcessorShare& share_;
  const double begin_ = processor_seconds();
};

PageCell cell_of(const PageJson& value) {
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return std::monostate{};
}

PageJson answer_of(const PageTable& table, bool typed) {
  PageJson rows = PageJson::array();
  for (const std::vector<PageCell>& row : table.rows) {
    PageJson cells = PageJson::array();
    for (const PageCell& cell : row) cells.push_back(json_of(cell, typed));
    rows.push_back(std::move(cells));
  }
  return {{"columns", table.columns}, {"rows", std::move(rows)}, {"cut", table.cut}};
}

/// As long a look at every byte of the longer one, wherever they differ.
bool same_token(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(i < b.size() ? b[i] : 0);
  return difference == 0U;
}

std::string cannot_listen(const PageServerOptions& options) {
  const bool host_is_at_fault = options.port == 0 || httplib::Server().bind_to_any_port(options.host) < 0;
  if (host_is_at_fault)
    return fmt::format(
        "{}: is no address of this machine that can be listened at; choose another with --host, or leave it out",
        options.host);
  return fmt::format("{}: cannot be listened to at port {}; choose another with --port", options.host, options.port);
}

/// The name in a Host header, without its port.
std::string host_name(const std::string& host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

/// As it stands in an address.
std::string address_name(const std::string& host) {
  if (host == "0.0.0.0") return "127.0.0.1";
  if (host == "::") return "[::1]";
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

/// A port that another program listens at is taken: the library would share it.
void take_alone(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

bool is_this_machine(const std::string& name) { return name == "127.0.0.1" || name == "localhost" || name == "[::1]"; }

/// As it is: set_content would compress it as well as can be, which takes seconds on its way to the same machine.
void send(httplib::Response& response, Text text, const char* type) {
  const std::size_t size = text->size();
  response.set_content_provider(
      size, type, [text = std::move(text)](std::size_t from, std::size_t length, httplib::DataSink& sink) {
        return sink.write(text->data() + from, length);
      });
}

Text text_of(const PageJson& answer) {
  return std::make_shared<const std::string>(answer.dump(-1, ' ', false, PageJson::error_handler_t::replace));
}

/// The pages' own tables change without the database.
bool is_cacheable(const std::string& sql) { return sql.find("page_replay") == std::string::npos; }

}  // namespace

/// What was answered since the database last changed, so that several viewers cost little more than one.
class PageAnswers {
 public:
  /// Null: not yet.
  Text find(const std::string& stamp, const std::string& question) {
    const std::lock_guard lock(mutex_);
    if (stamp != stamp_ || bytes_ > kMostBytes) {
      answers_.clear();
      bytes_ = 0;
      stamp_ = stamp;
    }
    const auto known = answers_.find(question);
    return known == answers_.end() ? nullptr : known->second;
  }
  void keep(const std::string& stamp, const std::string& question, const Text& answer) {
    const std::lock_guard lock(mutex_);
    if (stamp != stamp_ || answer->size() > kMostBytes / 4) return;
    bytes_ += answer->size();
    answers_.insert_or_assign(question, answer);
  }

 private:
  static constexpr std::size_t kMostBytes = 32'000'000;
  std::mutex mutex_;
  std::string stamp_;
  std::map<std::string, Text> answers_;
  std::size_t bytes_ = 0;
};

struct PageServer::Impl {
  explicit Impl(const PageServerOptions& of)
      : options(of), readable(of.database, of.pages.parent_path()), share(of.processor_share) {
    server.set_socket_options(take_alone);
    // A connection ends with its answer, so that no viewer keeps a thread.
    server.set_keep_alive_max_count(1);
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_payload_max_length(kLongestQuestion);
    server.set_default_headers({{"Cache-Control", "no-store"},
                                {"X-Content-Type-Options", "nosniff"},
                                {"X-Frame-Options", "DENY"},
                                {"Referrer-Policy", "no-referrer"}});
    server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      if (is_allowed(request)) return httplib::Server::HandlerResponse::Unhandled;
      response.status = 403;
      response.set_content("lacuna serve: open the address that it printed\n", "text/plain");
      return httplib::Server::HandlerResponse::Handled;
    });
    server.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      send(response, page, "text/html; charset=utf-8");
    });
    on("/sql", [this](const PageJson& question) {
      const Spending spending(share);
      return answer(question);
    });
    on("/state", [this](const PageJson&) {
      const Spending spending(share);
      return text_of({{"stamp", stamp_to_tell()}});
    });
    on("/replay", [this](const PageJson& question) {
      const std::int64_t run = question.at("run"), trial = question.at("trial");
      return text_of({{"replay", options.prepare_replay(run, trial)}});
    });
  }

  /// With a token whoever has it; without one this machine, by a name that no other site can give itself.
  bool is_allowed(const httplib::Request& request) const {
    if (options.token.empty()) return is_this_machine(host_name(request.get_header_value("Host")));
    const std::string token =
        request.method == "GET" ? request.get_param_value("token") : request.get_header_value("X-Lacuna-Token");
    return same_token(options.token, token);
  }

  /// Questions are JSON, and answers too, whatever goes wrong. Another site's page cannot send this content type
  /// unasked.
  void on(const char* path, std::function<Text(const PageJson&)> answer) {
    server.Post(path, [answer = std::move(answer)](const httplib::Request& request, httplib::Response& response) {
      try {
        if (!request.get_header_value("Content-Type").starts_with("application/json"))
          throw Error("a question is application/json");
        send(response, answer(PageJson::parse(request.body)), "application/json");
      } catch (const std::exception& error) {
        send(response, text_of({{"error", error.what()}}), "application/json");
      }
    });
  }

  /// A change is told when what the last one made viewers ask is within the share, and to all of them at once.
  std::string stamp_to_tell() {
    const std::lock_guard lock(telling);
    const std::string stamp = stamp_of(options.database);
    if (stamp.empty()) {
      told.clear();
      throw Error(fmt::format("{}: is gone; this page goes on when it is back", options.database.string()));
    }
    if (told.empty() || share.is_paid_off()) told = stamp;
    return told;
  }

  Text answer(const PageJson& question) {
    PageQuery query;
    query.sql = question.at("sql").get<std::string>();
    for (const PageJson& value : question.value("values", PageJson::array())) query.values.push_back(cell_of(value));
    query.most_rows = std::min(question.value("most", kMostRows), kMostRows);
    query.sizes = question.value("sizes", false);
    const std::string stamp = stamp_of(options.database), asked = question.dump();
    if (Text known = answers.find(stamp, asked)) return known;
    const std::shared_ptr<const std::filesystem::path> file = readable.file();  // shared: read until this is answered
    Text found = text_of(answer_of(ask_for_page(*file, options.pages, query), query.sizes));
    if (is_cacheable(query.sql)) answers.keep(stamp, asked, found);
    return found;
  }

  const PageServerOptions& options;
  ReadableDatabase readable;
  ProcessorShare share;
  std::mutex telling;
  std::string told;  ///< the stamp that viewers know
  PageAnswers answers;
  const std::shared_ptr<const std::string> page =
      std::make_shared<const std::string>(served_page());  // by answers under way
  httplib::Server server;
};

PageServer::PageServer(PageServerOptions options)
    : options_(std::move(options)), impl_(std::make_unique<Impl>(options_)) {
  port_ = options_.port == 0                                         ? impl_->server.bind_to_any_port(options_.host)
          : impl_->server.bind_to_port(options_.host, options_.port) ? options_.port
                                                                     : -1;
  if (port_ < 0) throw Error(cannot_listen(options_));
}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  return fmt::format("http://{}:{}/{}", address_name(options_.host), port_,
                     options_.token.empty() ? "" : "?token=" + options_.token);
}

void PageServer::run() { impl_->server.listen_after_bind(); }
void PageServer::stop() { impl_->server.stop(); }

}  // namespace lacuna
