#include "report/page_server.h"

#include "report/base64.h"
#include "report/pages.h"
#include "storage/page_query.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>
#include <map>
#include <mutex>

namespace lacuna {
namespace {

using PageJson = nlohmann::json;

using Text = std::shared_ptr<const std::string>;  ///< shared: an answer under way outlives the question

constexpr std::size_t kMostRows = 200'000;
constexpr int kThreads = 8;
constexpr std::size_t kLongestQuestion = 1'000'000;  ///< bytes

PageJson json_of(const PageCell& cell) {
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return *integer;
  if (const auto* number = std::get_if<double>(&cell))
    return std::isfinite(*number) ? PageJson(*number) : PageJson(nullptr);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* bytes = std::get_if<std::vector<std::byte>>(&cell)) return {{"base64", base64(*bytes)}};
  return nullptr;
}

/// Of this thread's work, s.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

PageCell cell_of(const PageJson& value) {
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return std::monostate{};
}

PageJson answer_of(const PageTable& table) {
  PageJson rows = PageJson::array();
  for (const std::vector<PageCell>& row : table.rows) {
    PageJson cells = PageJson::array();
    for (const PageCell& cell : row) cells.push_back(json_of(cell));
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

/// The name in a Host header, without its port.
std::string host_name(const std::string& host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
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
  explicit Impl(const PageServerOptions& of) : options(of) {
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
    on("/sql", [this](const PageJson& question, httplib::Response& response) {
      const double begin = processor_seconds();
      Text text = answer(question);
      response.set_header("X-Lacuna-Seconds", fmt::format("{:.6f}", processor_seconds() - begin));
      return text;
    });
    on("/state", [this](const PageJson&, httplib::Response&) {
      const std::string stamp = stamp_of(options.database);
      if (stamp.empty())
        throw Error(fmt::format("{}: is gone; this page goes on when it is back", options.database.string()));
      return text_of({{"stamp", stamp}});
    });
    on("/replay", [this](const PageJson& question, httplib::Response&) {
      options.prepare_replay(question.at("run").get<std::int64_t>(), question.at("trial").get<std::int64_t>());
      return text_of(PageJson::object());
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
  void on(const char* path, std::function<Text(const PageJson&, httplib::Response&)> answer) {
    server.Post(path, [answer = std::move(answer)](const httplib::Request& request, httplib::Response& response) {
      try {
        if (!request.get_header_value("Content-Type").starts_with("application/json"))
          throw Error("a question is application/json");
        send(response, answer(PageJson::parse(request.body), response), "application/json");
      } catch (const std::exception& error) {
        send(response, text_of({{"error", error.what()}}), "application/json");
      }
    });
  }

  Text answer(const PageJson& question) {
    PageQuery query;
    query.sql = question.at("sql").get<std::string>();
    for (const PageJson& value : question.value("values", PageJson::array())) query.values.push_back(cell_of(value));
    query.most_rows = std::min(question.value("most", kMostRows), kMostRows);
    const std::string stamp = stamp_of(options.database), asked = question.dump();
    if (Text known = answers.find(stamp, asked)) return known;
    Text found = text_of(answer_of(ask_for_page(options.database, options.pages, query)));
    if (is_cacheable(query.sql)) answers.keep(stamp, asked, found);
    return found;
  }

  const PageServerOptions& options;
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
  if (port_ < 0)
    throw Error(
        fmt::format("{}: cannot be listened to at port {}; choose another with --port", options_.host, options_.port));
}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  const std::string host = options_.host == "0.0.0.0" ? "127.0.0.1" : options_.host;
  return fmt::format("http://{}:{}/{}", host, port_, options_.token.empty() ? "" : "?token=" + options_.token);
}

void PageServer::run() { impl_->server.listen_after_bind(); }
void PageServer::stop() { impl_->server.stop(); }

}  // namespace lacuna
