#include "report/pages/page_server.h"

#include "report/pages/pages.h"
#include "report/pages/processor_share.h"
#include "storage/pages/page_database.h"
#include "storage/results/result_store.h"
#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <fmt/format.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <thread>

namespace lacuna {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;
using namespace std::chrono_literals;

TEST(ProcessorShare, IsPaidOffByTime) {
  ProcessorShare share(0.02);
  const ProcessorShare::Clock::time_point begin = ProcessorShare::Clock::now();
  EXPECT_TRUE(share.is_paid_off(begin));
  share.spend(1.0, begin);
  share.spend(1.0, begin);
  EXPECT_FALSE(share.is_paid_off(begin + 99s));
  EXPECT_TRUE(share.is_paid_off(begin + 101s));
  share.spend(0.1, begin + 1000s);  // rest is not saved up
  EXPECT_FALSE(share.is_paid_off(begin + 1004s));
  EXPECT_TRUE(share.is_paid_off(begin + 1006s));
}

/// A server that answers until the test ends.
class Answering {
 public:
  explicit Answering(PageServerOptions options) : server_(std::move(options)), thread_([this] { server_.run(); }) {}
  ~Answering() {
    server_.stop();
    thread_.join();
  }
  Json ask(const char* path, const Json& question) const {
    const httplib::Result answer = post(path, question, {{"X-Lacuna-Token", token()}});
    return answer ? Json::parse(answer->body) : Json("no answer");
  }
  httplib::Result post(const char* path, const Json& question, const httplib::Headers& headers) const {
    return client().Post(path, headers, question.dump(), "application/json");
  }
  httplib::Client client() const {
    httplib::Client client("127.0.0.1", server_.port());
    client.set_read_timeout(60s);
    return client;
  }
  std::string token() const { return server_.address().substr(server_.address().find("token=") + 6); }
  int port() const { return server_.port(); }

 private:
  PageServer server_;
  std::thread thread_;
};

class PageServerTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_pages()) GTEST_SKIP() << "built without pages";
  }
  PageServerOptions options() const {
    return {.database = file_,
            .pages = folder_ / "pages.db",
            .prepare_replay = [](std::int64_t run, std::int64_t trial) { return 10 * run + trial; }};
  }
  void commit() {
    ResultStore store(database_);
    store.begin_run({.command = "lacuna fit rig.toml", .seed = 1, .threads = 1}, provenance_of_this_program());
    store.end_run(RunEnding::done);
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db";
  Database database_ = Database::open(file_);
  PageDatabase pages_{folder_ / "pages.db"};
};

TEST_F(PageServerTest, DoesNotShareAPort) {
  PageServerOptions second = options();
  const Answering first(options());
  second.port = first.port();
  EXPECT_THROW(PageServer{second}, Error);
}

TEST_F(PageServerTest, SaysWhetherTheAddressOrThePortIsWrong) {
  const auto fault_of = [](const PageServerOptions& options) -> std::string {
    try {
      const PageServer server(options);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  PageServerOptions wrong = options();
  const Answering first(options());
  wrong.port = first.port();
  EXPECT_THAT(fault_of(wrong), HasSubstr("choose another with --port"));
  wrong.host = "192.0.2.1";  // of documentation alone (RFC 5737)
  EXPECT_THAT(fault_of(wrong), HasSubstr("choose another with --host"));
  wrong.port = 0;
  EXPECT_THAT(fault_of(wrong), HasSubstr("choose another with --host"));
}

TEST_F(PageServerTest, PrintsAddressesThatBrowsersTake) {
  PageServerOptions six = options();
  six.host = "::1";
  try {
    const PageServer server(six);
    EXPECT_THAT(server.address(), HasSubstr("http://[::1]:"));
    six.host = "::";
    EXPECT_THAT(PageServer(six).address(), HasSubstr("http://[::1]:"));
  } catch (const Error&) {
    GTEST_SKIP() << "this machine has no IPv6";
  }
}

TEST_F(PageServerTest, SendsLargeIntegersAsTheyAreAndSizesOfBytes) {
  const Answering server(options());
  const Json answer = server.ask(
      "/sql", {{"sql", "SELECT 9007199254740993, 9007199254740992, x'0102', 'a' || char(0) || 'b'"}, {"sizes", true}});
  EXPECT_EQ(answer.at("rows"), Json::parse(R"([["9007199254740993", 9007199254740992, {"bytes": 2}, "a\u0000b"]])"));
  EXPECT_EQ(server.ask("/sql", {{"sql", "SELECT x'0102'"}}).at("rows"), Json::parse(R"([[{"base64": "AQI="}]])"));
  EXPECT_EQ(server.ask("/sql", {{"sql", "SELECT 1e999, -1e999"}, {"sizes", true}}).at("rows"),
            Json::parse(R"([["Infinity", "-Infinity"]])"));
  EXPECT_EQ(server.ask("/sql", {{"sql", "SELECT 1e999"}}).at("rows"), Json::parse("[[null]]"));
  EXPECT_THAT(server.ask("/sql", {{"sql", "DELETE FROM run"}}).at("error"), HasSubstr("only reading is allowed"));
}

TEST_F(PageServerTest, TellsAChangeToAllViewersWhenTheLastOneIsPaidFor) {
  const Answering server(options());
  const Json before = server.ask("/state", {});
  // Two viewers' work, of which one fails: some milliseconds, for which 2 % take a while.
  const char* work = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 100000) ";
  server.ask("/sql", {{"sql", std::string(work) + "SELECT count(*) FROM n"}});
  EXPECT_TRUE(server.ask("/sql", {{"sql", std::string(work) + "SELECT abs(-9223372036854775808 + 0 * sum(i)) FROM n"}})
                  .contains("error"));
  commit();
  EXPECT_EQ(server.ask("/state", {}), before);
  Json after = before;
  for (int i = 0; i < 600 && after == before; ++i) {
    std::this_thread::sleep_for(100ms);
    after = server.ask("/state", {});
  }
  EXPECT_NE(after, before);
}

int http_status(const httplib::Result& answer) { return answer ? answer->status : 0; }

TEST_F(PageServerTest, NeedsItsTokenOnThisMachineToo) {
  const Answering server(options());
  EXPECT_EQ(http_status(server.client().Get("/")), 403);
  EXPECT_EQ(http_status(server.client().Get("/?token=" + std::string(32, '0'))), 403);
  EXPECT_EQ(http_status(server.client().Get("/?token=" + server.token())), 200);
  const Json question = {{"sql", "SELECT 1"}};
  for (const char* path : {"/sql", "/show", "/state", "/replay", "/other"})
    EXPECT_EQ(http_status(server.post(path, question, {})), 403) << path;
  EXPECT_EQ(http_status(server.post("/sql", question, {{"X-Lacuna-Token", server.token()}})), 200);
  EXPECT_EQ(http_status(server.post("/other", question, {{"X-Lacuna-Token", server.token()}})), 404);
}

TEST_F(PageServerTest, RefusesOtherSitesAndNames) {
  const Answering server(options());
  const Json question = {{"sql", "SELECT 1"}};
  const auto status = [&](const char* name, const char* value) {
    return http_status(server.post("/sql", question, {{"X-Lacuna-Token", server.token()}, {name, value}}));
  };
  EXPECT_EQ(status("Origin", "http://evil.example"), 403);
  EXPECT_EQ(status("Origin", "null"), 403);
  EXPECT_EQ(status("Host", "evil.example"), 403);
  EXPECT_EQ(status("Sec-Fetch-Site", "cross-site"), 403);
  EXPECT_EQ(status("Sec-Fetch-Site", "same-origin"), 200);
}

TEST_F(PageServerTest, AnswersPagesWhileEndlessQueriesRun) {
  const Answering server(options());
  std::vector<std::thread> askers;
  std::atomic<int> refused = 0, ended = 0;
  for (int i = 0; i < 24; ++i)
    askers.emplace_back([&, i] {
      httplib::Client client = server.client();
      client.set_read_timeout(3s);  // and goes away
      const std::string endless =
          fmt::format("WITH RECURSIVE n(i) AS (SELECT {} UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n", i);
      const httplib::Result answer =
          client.Post("/sql", {{"X-Lacuna-Token", server.token()}}, Json{{"sql", endless}}.dump(), "application/json");
      ++ended;
      if (http_status(answer) == 503) {
        ++refused;
        EXPECT_THAT(Json::parse(answer->body).at("error"), HasSubstr("too many requests"));
        EXPECT_TRUE(answer->has_header("Retry-After"));
      }
    });
  while (refused == 0 && ended < 24) std::this_thread::sleep_for(10ms);
  for (int i = 0; i < 20; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(http_status(server.client().Get("/?token=" + server.token())), 200);
    EXPECT_TRUE(server.ask("/state", {}).contains("stamp"));
    const Json shown = server.ask("/show", {{"sql", fmt::format("SELECT {}", i)}});
    EXPECT_EQ(shown.value("rows", Json()), Json::array({Json::array({i})})) << shown;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
  }
  for (std::thread& asker : askers) asker.join();
  EXPECT_GE(refused, 4);
  // What waited has gone with its clients: only what runs is waited for.
  const auto begin = std::chrono::steady_clock::now();
  const Json typed = server.ask("/sql", {{"sql", "SELECT 7"}});
  EXPECT_EQ(typed.value("rows", Json()), Json::parse("[[7]]")) << typed;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 15s);
}

TEST_F(PageServerTest, LimitsAnswers) {
  const Answering server(options());
  const char* controls =
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 30) "
      "SELECT replace(hex(zeroblob(500000)), '0', char(1)) FROM n";  // six times as long as JSON
  EXPECT_THAT(server.ask("/sql", {{"sql", controls}}).at("error"), HasSubstr("select fewer rows or columns"));
}

TEST_F(PageServerTest, PreparesReplays) {
  const Answering server(options());
  EXPECT_EQ(server.ask("/replay", {{"run", 2}, {"trial", 3}}), Json::parse(R"({"replay": 23})"));
  EXPECT_TRUE(server.ask("/replay", {{"run", "x"}}).contains("error"));
}

TEST_F(PageServerTest, RefusesQuestionsThatNestTooDeepOrAreNoJson) {
  const Answering server(options());
  constexpr std::size_t kDeep = 80'000;
  const std::string arrays = std::string(kDeep, '[') + std::string(kDeep, ']');
  std::string objects;
  for (std::size_t i = 0; i < kDeep; ++i) objects += R"({"a":)";
  objects += "1" + std::string(kDeep, '}');
  const std::string wrapped = R"({"sql": "SELECT 1", "values": )" + arrays + "}";
  for (const char* path : {"/sql", "/show", "/state", "/replay"})
    for (const std::string& question : {arrays, objects, wrapped, arrays.substr(0, kDeep), std::string("{")}) {
      const httplib::Result answer =
          server.client().Post(path, {{"X-Lacuna-Token", server.token()}}, question, "application/json");
      EXPECT_EQ(http_status(answer), 400) << path << " " << question.substr(0, 40);
      EXPECT_TRUE(answer && Json::parse(answer->body).contains("error"));
    }
  EXPECT_TRUE(server.ask("/sql", {{"sql", "SELECT 1"}}).contains("rows")) << "and goes on";
}

}  // namespace
}  // namespace lacuna
