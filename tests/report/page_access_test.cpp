#include "report/pages/page_access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string kToken = "0123456789abcdef";

WebRequest get(const std::string& host, std::map<std::string, std::string, std::less<>> more = {}) {
  more["host"] = host;
  return {.method = "GET", .path = "/", .query = "token=" + kToken, .body = "", .headers = std::move(more)};
}

WebRequest post(const std::string& host, std::map<std::string, std::string, std::less<>> more = {}) {
  more["host"] = host;
  more.emplace("x-lacuna-token", kToken);
  return {.method = "POST", .path = "/sql", .query = "", .body = "{}", .headers = std::move(more)};
}

TEST(PageAccessTest, NeedsTheToken) {
  const PageAccess access(kToken, "127.0.0.1");
  EXPECT_THAT(access.refusal(get("127.0.0.1:80")), IsEmpty());
  EXPECT_THAT(access.refusal(post("127.0.0.1:80")), IsEmpty());
  for (const std::string& wrong : {std::string(), kToken + "0", kToken.substr(1), std::string("x123456789abcdef")}) {
    EXPECT_THAT(access.refusal(post("127.0.0.1:80", {{"x-lacuna-token", wrong}})), HasSubstr("token")) << wrong;
    WebRequest request = get("127.0.0.1:80");
    request.query = "token=" + wrong;
    EXPECT_THAT(access.refusal(request), HasSubstr("token")) << wrong;
  }
  WebRequest in_address = post("127.0.0.1:80", {{"x-lacuna-token", ""}});
  in_address.query = "token=" + kToken;
  EXPECT_THAT(access.refusal(in_address), HasSubstr("token"))
      << "of a question it is in a header, which sites cannot set";
}

TEST(PageAccessTest, AnswersToNamesOfThisMachine) {
  const PageAccess here(kToken, "127.0.0.1");
  for (const char* host : {"127.0.0.1:80", "localhost:80", "LOCALHOST", "[::1]:80"})
    EXPECT_THAT(here.refusal(get(host)), IsEmpty()) << host;
  for (const char* host : {"", "evil.example:80", "127.0.0.1.evil.example", "192.0.2.1:80", "[", ":80"})
    EXPECT_THAT(here.refusal(get(host)), HasSubstr("does not belong to this machine")) << host;
  const PageAccess everywhere(kToken, "0.0.0.0");
  for (const char* host : {"192.0.2.1:80", "[2001:db8::1]:80", "localhost"})
    EXPECT_THAT(everywhere.refusal(get(host)), IsEmpty()) << host;
  EXPECT_THAT(everywhere.refusal(get("evil.example:80")), HasSubstr("does not belong to this machine"));
  EXPECT_THAT(PageAccess(kToken, "Rig.example").refusal(get("rig.example:80")), IsEmpty());
}

TEST(PageAccessTest, IsReachedThroughATunnel) {
  const PageAccess access(kToken, "127.0.0.1");
  const char* const here = "127.0.0.1:8080";  // ssh -L 8080:127.0.0.1:PORT
  EXPECT_THAT(access.refusal(get(here)), IsEmpty());
  EXPECT_THAT(access.refusal(post(here, {{"origin", "http://127.0.0.1:8080"}})), IsEmpty());
  EXPECT_THAT(access.refusal(post(here, {{"origin", "http://127.0.0.1:8081"}})), HasSubstr("other sites"));
}

TEST(PageAccessTest, RefusesOtherSitesPages) {
  const PageAccess access(kToken, "127.0.0.1");
  EXPECT_THAT(access.refusal(post("127.0.0.1:80", {{"origin", "http://127.0.0.1:80"}})), IsEmpty());
  EXPECT_THAT(access.refusal(post("127.0.0.1:80", {{"sec-fetch-site", "same-origin"}})), IsEmpty());
  for (const char* origin : {"null", "http://evil.example", "http://127.0.0.1:81", "http://localhost:80", "file://"})
    EXPECT_THAT(access.refusal(post("127.0.0.1:80", {{"origin", origin}})), HasSubstr("other sites")) << origin;
  for (const char* site : {"cross-site", "same-site"})
    EXPECT_THAT(access.refusal(post("127.0.0.1:80", {{"sec-fetch-site", site}})), HasSubstr("other sites")) << site;
}

TEST(PageAccessTest, LetsAnAddressBeOpenedFromAnywhereButNotFramed) {
  const PageAccess access(kToken, "127.0.0.1");
  const auto opened = [&](const char* mode, const char* destination) {
    return access.refusal(get(
        "127.0.0.1:80", {{"sec-fetch-site", "cross-site"}, {"sec-fetch-mode", mode}, {"sec-fetch-dest", destination}}));
  };
  EXPECT_THAT(opened("navigate", "document"), IsEmpty());
  EXPECT_THAT(opened("navigate", "iframe"), HasSubstr("other sites"));
  EXPECT_THAT(opened("no-cors", "script"), HasSubstr("other sites"));
}

TEST(PageAccessTest, TokensAre128BitsAndDiffer) {
  EXPECT_EQ(random_token().size(), 32U);
  EXPECT_NE(random_token(), random_token());
}

}  // namespace
}  // namespace lacuna
