#include "report/pages/page_server.h"

#include "foundation/text/json_depth.h"
#include "report/pages/page_access.h"
#include "report/pages/page_answers.h"
#include "report/pages/page_json.h"
#include "report/pages/pages.h"
#include "report/pages/processor_share.h"
#include "report/pages/web_server.h"
#include "report/pages/question_queue.h"
#include "storage/pages/readable_database.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace lacuna {
namespace {

using PageJson = nlohmann::json;
using Text = PageAnswers::Text;

constexpr std::size_t kMostRows = 1'000'000;
constexpr std::size_t kLongestAnswer = 128'000'000;  ///< bytes of JSON

/// Of this thread's work, s.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Charges the processor time of this thread, until it ends in any way, to a share.
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

/// As it stands in an address.
std::string address_name(const std::string& host) {
  if (host == "0.0.0.0") return "127.0.0.1";
  if (host == "::") return "[::1]";
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

Text text_of(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

WebAnswer plain(int status, const std::string& sentence) {
  return {status, "text/plain; charset=utf-8", text_of("lacuna serve: " + sentence + "\n")};
}

WebAnswer trouble(int status, const std::string& sentence) {
  return {status, "application/json", text_of(page_json(PageJson{{"error", sentence}}))};
}

/// The pages' own tables change without the database.
bool is_cacheable(const std::string& sql) { return sql.find("page_replay") == std::string::npos; }

/// Questions are JSON, and answers too, whatever goes wrong.
template <typename Answer>
WebAnswer answer_to(const std::string& question, const Answer& answer) {
  if (nests_too_deep(question))
    return trouble(400, fmt::format("the request nests arrays and objects more than {} levels deep", kDeepestJson));
  try {
    return {200, "application/json", answer(PageJson::parse(question))};
  } catch (const PageJson::exception& error) {
    return trouble(400, std::string("the request cannot be read: ") + error.what());
  } catch (const std::exception& error) {
    return trouble(200, error.what());
  }
}

}  // namespace

struct PageServer::Impl {
  explicit Impl(PageServerOptions with)
      : options(std::move(with)),
        readable(options.database, options.pages.parent_path(), options.stop),
        share(options.processor_share),
        web({.host = options.host, .port = options.port, .handle = [this](WebRequest request, const WebReply& reply) {
               route(std::move(request), reply);
             }}) {}

  void route(WebRequest request, const WebReply& reply) {
    if (const std::string why = access.refusal(request); !why.empty()) return reply(plain(403, why));
    if (request.method == "GET" && request.path == "/") return reply({200, "text/html; charset=utf-8", page});
    if (request.method != "POST") return reply(plain(404, "there is no such page"));
    // Another site's page cannot send this content type unasked.
    if (!request.header("content-type").starts_with("application/json"))
      return reply(trouble(415, "a request must be application/json"));
    if (request.path == "/state")
      return reply(answer_to(request.body, [this](const PageJson&) { return answer_state(); }));
    if (request.path == "/show")
      return ask(showing, std::move(request.body), reply, [this](const PageJson& asked) { return answer_sql(asked); });
    if (request.path == "/sql")
      return ask(typed, std::move(request.body), reply, [this](const PageJson& asked) { return answer_sql(asked); });
    if (request.path == "/replay")
      return ask(replays, std::move(request.body), reply,
                 [this](const PageJson& asked) { return answer_replay(asked); });
    reply(plain(404, "there is no such request"));
  }

  /// A question whose client has gone before its turn is dropped.
  template <typename Answer>
  static void ask(QuestionQueue& queue, std::string question, const WebReply& reply, Answer answer) {
    const auto work = [question = std::move(question), reply, answer = std::move(answer)] {
      reply(answer_to(question, answer));
    };
    if (!queue.add(work, [reply] { return reply.is_wanted(); }))
      reply(trouble(503, "too many requests are waiting; try again later"));
  }

  Text answer_state() {
    const Spending spending(share);
    return text_of(page_json(PageJson{{"stamp", stamp_to_tell()}}));
  }

  Text answer_replay(const PageJson& question) const {
    const std::int64_t run = question.at("run"), trial = question.at("trial");
    return text_of(page_json(PageJson{{"replay", options.prepare_replay(run, trial)}}));
  }

  Text answer_sql(const PageJson& question) {
    const Spending spending(share);
    PageQuery query;
    query.sql = question.at("sql").get<std::string>();
    for (const PageJson& value : question.value("values", PageJson::array()))
      query.values.push_back(page_cell_of(value));
    query.most_rows = std::min(question.value("most", kMostRows), kMostRows);
    query.sizes = question.value("sizes", false);
    const std::string stamp = stamp_of(options.database), asked = question.dump();
    if (Text known = answers.find(stamp, asked)) return known;
    const std::shared_ptr<const std::filesystem::path> file = readable.file();  // shared: read until this is answered
    const PageTable table = ask_for_page(*file, options.pages, query, options.stop);
    Text found = text_of(page_json(table, query.sizes, kLongestAnswer));
    if (is_cacheable(query.sql)) answers.keep(stamp, asked, found);
    return found;
  }

  /// A change is announced, to all viewers at once, when the requests that the last change caused are within the share.
  std::string stamp_to_tell() {
    const std::string stamp = stamp_of(options.database);
    if (stamp.empty()) {
      told.clear();
      throw Error(
          fmt::format("{}: the file is missing; the page continues when it is back", options.database.string()));
    }
    if (told.empty() || share.is_paid_off()) told = stamp;
    return told;
  }

  const PageServerOptions options;
  const std::string token = random_token();
  const PageAccess access{token, options.host};
  const Text page = text_of(served_page());
  ReadableDatabase readable;
  ProcessorShare share;
  std::string told;  ///< the stamp that viewers know
  PageAnswers answers;
  WebServer web;
  // These end before the server does. What a user typed may take long and waits apart from what pages show.
  QuestionQueue showing{4, 64}, typed{2, 16}, replays{1, 8};
};

PageServer::PageServer(PageServerOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
PageServer::~PageServer() = default;

int PageServer::port() const { return impl_->web.port(); }

std::string PageServer::address() const {
  return fmt::format("http://{}:{}/?token={}", address_name(impl_->options.host), port(), impl_->token);
}

void PageServer::run() { impl_->web.run(); }
void PageServer::stop() { impl_->web.stop(); }

}  // namespace lacuna
