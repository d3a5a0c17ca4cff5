#include "report/pages/pages.h"

#include "report/pages/base64.h"
#include "report/pages/gzip.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

namespace lacuna {
namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

std::vector<std::byte> unpacked(const std::vector<std::byte>& packed, std::size_t size) {
  constexpr int kGzipWindow = 15 + 16;
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, kGzipWindow), Z_OK);
  std::vector<std::byte> bytes(size + 1);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  inflateEnd(&stream);
  return bytes;
}

TEST(Base64, IsThatOfRfc4648) {
  const std::pair<const char*, const char*> kVectors[] = {{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foob", "Zm9vYg=="},
                                                          {"fooba", "Zm9vYmE="},
                                                          {"foobar", "Zm9vYmFy"}};
  for (const auto& [text, coded] : kVectors) EXPECT_EQ(base64(bytes_of(text)), coded);
  EXPECT_EQ(base64(bytes_of("\xfb\xff\xfe")), "+//+");
}

TEST(Gzip, ComesBackAsItWas) {
  std::mt19937 random(1);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{100'000}}) {
    std::vector<std::byte> bytes(size);
    for (std::byte& one : bytes) one = static_cast<std::byte>(random() & 0xffU);
    EXPECT_EQ(unpacked(gzip(bytes), size), bytes) << size;
    EXPECT_EQ(gzip(bytes), gzip(bytes)) << "nothing of the time or machine is in it";
  }
}

TEST(Pages, CarryTheDatabaseAndForbidOtherOrigins) {
  const std::vector<std::byte> database = bytes_of("a database");
  if (!has_pages()) {  // LACUNA_REPORT=OFF, or no Node.js
    EXPECT_THROW(report_page(database), Error);
    EXPECT_THROW(served_page(), Error);
    return;
  }
  const std::string page = report_page(database);
  EXPECT_THAT(page, testing::HasSubstr("id=\"lacuna-data\">" + base64(gzip(database)) + "</script>"));
  EXPECT_THAT(page, testing::HasSubstr("default-src 'none'; script-src 'sha256-"));
  EXPECT_THAT(page, testing::HasSubstr("connect-src 'none';"));
  EXPECT_THAT(served_page(), testing::HasSubstr("connect-src 'self';"));
  EXPECT_THAT(served_page(), testing::Not(testing::HasSubstr("id=\"lacuna-data\">")));
  EXPECT_LT(served_page().size(), 3'000'000U);
}

}  // namespace
}  // namespace lacuna
