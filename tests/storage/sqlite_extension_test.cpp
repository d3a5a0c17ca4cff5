#include "storage/made_up_run.h"
#include "support/sanitizers.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// What a shell command prints, errors included.
std::string printed_by(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), &pclose);
  std::string text;
  std::array<char, 4096> block{};
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), pipe.get())) {
    text.append(block.data(), size);
  }
  return text;
}

/// The extension in the program that most users have, which brings its own SQLite.
class SqliteExtension : public testing::Test {
 protected:
  void SetUp() override {
#if LACUNA_WATCHED
    GTEST_SKIP() << "sqlite3 has not the sanitizer that the extension needs";
#endif
    if (printed_by("command -v sqlite3").empty()) GTEST_SKIP() << "the program sqlite3 is not installed";
    Database database = Database::open(folder_ / "rig.db");
    ResultStore store(database);
    test::fill_small_database(store);
    test::add_made_up_run(database);
  }
  std::string ask(const std::string& sql) const {
    return printed_by(fmt::format("sqlite3 -batch -csv {} -cmd '.load {}/lib/lacuna/lacuna_sqlite' \"{}\"",
                                  (folder_ / "rig.db").string(), LACUNA_BINARY_DIRECTORY, sql));
  }
  const TestFolder folder_;
};

TEST_F(SqliteExtension, GivesSamplesAsRowsWithEveryDigit) {
  const TimeSeries series = test::sine(1000);
  EXPECT_EQ(ask("SELECT count(*), max(sample), max(time), min(channel) FROM traces, trace_samples(traces.id)"
                " WHERE trial = 'sine' AND kind = 'measured'"),
            "1000,999,0.999,angle\n");
  const std::string exact = ask(
      "SELECT printf('%!.17g', value) FROM traces, trace_samples(traces.id) WHERE trial = 'sine' AND kind = 'measured'"
      " AND sample = 17");
  EXPECT_EQ(std::stod(exact), series.samples(17, 0));
}

TEST_F(SqliteExtension, ReadsWhatAModelPredictedOfTheCentreOfMass) {
  EXPECT_EQ(ask("SELECT channel, value FROM traces, trace_samples(traces.id) WHERE model = 100 AND sample = 3"
                " AND kind = 'centre_of_mass'"),
            "x,1.0\ny,1.0\nz,1.0\n");
}

TEST_F(SqliteExtension, SaysWhatIsWrongInASentence) {
  EXPECT_THAT(ask("SELECT * FROM trace_samples(12)"), HasSubstr("the database has no trace 12"));
  EXPECT_THAT(ask("SELECT * FROM trace_samples"), HasSubstr("trace_samples needs the key of a trace"));
  EXPECT_THAT(ask("DROP VIEW traces; DROP TABLE trace; SELECT * FROM trace_samples(1)"),
              HasSubstr("not a Lacuna database"));
}

TEST_F(SqliteExtension, NoticesAFlippedBit) {
  EXPECT_THAT(ask("UPDATE trace SET samples = CAST(x'01' || substr(samples, 2) AS BLOB);"
                  "SELECT count(*) FROM traces, trace_samples(traces.id)"),
              HasSubstr("is damaged"));
}

}  // namespace
}  // namespace lacuna
