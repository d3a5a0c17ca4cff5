#include "report/pages/web_server.h"

#include "report/raw_client.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <future>
#include <thread>

namespace lacuna {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* kGet = "GET /page?a=1&token=t HTTP/1.1\r\nHost: localhost\r\n\r\n";

WebAnswer text_answer(const std::string& text) {
  return {200, "text/plain", std::make_shared<const std::string>(text)};
}

/// Answers with what it understood; to /never not at all, but keeps the reply.
class Echo {
 public:
  explicit Echo(WebLimits limits = {})
      : server_({.host = "127.0.0.1",
                 .limits = limits,
                 .handle =
                     [this](WebRequest request, WebReply reply) {
                       if (request.path == "/never") return kept_.set_value(std::move(reply));
                       reply(text_answer(request.method + " " + request.path + " " + request.parameter("token") + " " +
                                         request.header("host") + " " + std::to_string(request.body.size())));
                     }}),
        thread_([this] { server_.run(); }) {}
  ~Echo() {
    server_.stop();
    thread_.join();
  }
  int port() const { return server_.port(); }
  std::optional<std::string> ask(std::string_view bytes) const {
    const RawClient client(port());
    client.send(bytes);
    return client.read_all();
  }
  WebReply kept() { return kept_.get_future().get(); }

 private:
  std::promise<WebReply> kept_;
  WebServer server_;
  std::thread thread_;
};

std::string chunk(std::size_t size) { return fmt::format("{:x}\r\n{}\r\n", size, std::string(size, 'x')); }

TEST(WebServerTest, AnswersAndEnds) {
  const Echo echo;
  const auto answer = echo.ask(kGet);
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_THAT(*answer, HasSubstr("GET /page t localhost 0"));
  EXPECT_THAT(*answer, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_EQ(status_of(echo.ask("POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n" + chunk(1000) +
                               chunk(500) + "0\r\n\r\n")),
            200);
}

TEST(WebServerTest, IsNotHeldUpBySilentClients) {
  const Echo echo;
  std::deque<RawClient> silent;
  for (int i = 0; i < 300; ++i) silent.emplace_back(echo.port());
  const Clock::time_point begin = Clock::now();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(status_of(echo.ask(kGet)), 200);
  EXPECT_LT(Clock::now() - begin, 2s);
  const auto told = silent.front().read_all(1s);
  EXPECT_EQ(status_of(told), 503) << "the oldest made room";
  EXPECT_THAT(told.value_or(""), HasSubstr("\r\nRetry-After: 1\r\n"));
}

TEST(WebServerTest, AnswersEveryOneOfManyClientsAtOnce) {
  constexpr int kClients = 500, kRounds = 4;
  const Echo echo;
  const Clock::time_point begin = Clock::now();
  for (int round = 0; round < kRounds; ++round) {
    std::deque<RawClient> clients;
    for (int i = 0; i < kClients; ++i) clients.emplace_back(echo.port());
    for (const RawClient& client : clients) client.send(kGet);
    int answered = 0;
    for (const RawClient& client : clients) {
      const int status = status_of(client.read_all());
      answered += status == 200 || status == 503 ? 1 : 0;
    }
    EXPECT_EQ(answered, kClients);
  }
  EXPECT_LT(Clock::now() - begin, 20s);
}

/// Those in front take their time, but not for ever.
TEST(WebServerTest, LetsNewClientsWaitBehindManyThatHaveJustCome) {
  const Echo echo({.connections = 4, .patience = 300ms});
  std::deque<RawClient> first;
  for (int i = 0; i < 4; ++i) first.emplace_back(echo.port());
  const RawClient next(echo.port());
  next.send(kGet);
  std::this_thread::sleep_for(100ms);
  for (const RawClient& client : first) client.send(kGet);
  for (const RawClient& client : first) EXPECT_EQ(status_of(client.read_all()), 200);
  EXPECT_EQ(status_of(next.read_all()), 200);
}

TEST(WebServerTest, EndsClientsThatSendTooSlowly) {
  const Echo echo({.request = 500ms});
  const RawClient silent(echo.port()), dripping(echo.port());
  const Clock::time_point begin = Clock::now();
  dripping.send("GET / HTTP/1.1\r\nX: ");
  while (dripping.send("x") && Clock::now() - begin < 5s) {
    std::this_thread::sleep_for(20ms);
    EXPECT_EQ(status_of(echo.ask(kGet)), 200);
  }
  EXPECT_LT(Clock::now() - begin, 3s);
  EXPECT_EQ(silent.read_all(1s), "");
}

TEST(WebServerTest, RefusesOversizedHeaders) {
  const Echo echo;
  EXPECT_EQ(status_of(echo.ask("GET /" + std::string(100'000, 'x') + " HTTP/1.1\r\n\r\n")), 431);
  EXPECT_EQ(status_of(echo.ask("GET / HTTP/1.1\r\nX: " + std::string(100'000, 'x') + "\r\n\r\n")), 431);
  std::string many = "GET / HTTP/1.1\r\n";
  for (int i = 0; i < 10'000; ++i) many += fmt::format("X{}: y\r\n", i);
  EXPECT_EQ(status_of(echo.ask(many + "\r\n")), 431);
}

TEST(WebServerTest, RefusesOversizedBodiesHoweverTheyAreSent) {
  const Echo echo;
  const std::string post = "POST / HTTP/1.1\r\nHost: a\r\n";
  EXPECT_EQ(status_of(echo.ask(post + "Content-Length: 2000000\r\n\r\n")), 413);
  EXPECT_EQ(status_of(echo.ask(post + "Content-Length: 99999999999999999999999\r\n\r\n")), 400);
  EXPECT_EQ(status_of(echo.ask(post + "Content-Length: 1000000\r\n\r\n" + std::string(1'000'000, 'x'))), 200);
  const std::string chunked = post + "Transfer-Encoding: chunked\r\n\r\n";
  EXPECT_EQ(status_of(echo.ask(chunked + chunk(3'000'000))), 413);
  std::string many = chunked;
  for (int i = 0; i < 300; ++i) many += chunk(10'000);
  EXPECT_EQ(status_of(echo.ask(many)), 413);
  EXPECT_EQ(status_of(echo.ask(chunked + "5;" + std::string(200'000, 'e'))), 413) << "an extension of a chunk";
}

TEST(WebServerTest, RefusesWhatIsNoHttp) {
  const Echo echo;
  EXPECT_EQ(status_of(echo.ask("\x16\x03\x01\x02 no\r\n\r\n")), 400);
  EXPECT_EQ(status_of(echo.ask("GET / HTTP/1.1\r\nno colon\r\n\r\n")), 400);
}

TEST(WebServerTest, KnowsWhenAClientHasGone) {
  Echo echo;
  RawClient client(echo.port());
  client.send("GET /never HTTP/1.1\r\nHost: a\r\n\r\n");
  const WebReply reply = echo.kept();
  EXPECT_TRUE(reply.is_wanted());
  client.close();
  for (int i = 0; i < 500 && reply.is_wanted(); ++i) std::this_thread::sleep_for(10ms);
  EXPECT_FALSE(reply.is_wanted());
  reply(text_answer("into nothing"));
}

TEST(WebServerTest, HearsAStopBeforeItRuns) {
  WebServer server({.host = "127.0.0.1", .handle = [](const WebRequest&, const WebReply&) {}});
  server.stop();
  server.run();
}

}  // namespace
}  // namespace lacuna
