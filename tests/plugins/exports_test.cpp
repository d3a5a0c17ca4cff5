#include "measurement/csv/csv_table.h"
#include "plugins/recording_files.h"
#include "report/exports/mcap_trace.h"
#include "report/exports/mcap_writer.h"
#include "report/exports/numpy_output.h"
#include "report/exports/trace_rows.h"
#include "report/exports/zip_writer.h"
#include "storage/queries/query_output.h"

#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Numbers that do not survive a digit less; some are missing, and one time has a reading and no prediction.
NamedTrace some_trace() {
  TimeSeries measured, predicted;
  measured.channels = {{"angle", "rad"}, {"rate", "rad/s"}};
  measured.times = Eigen::Vector4d(0.0, 0.1, 0.2 + 1e-9, 1.0 / 3.0);
  measured.samples.resize(4, 2);
  measured.samples << 0.1, kNone, -1.0 / 3.0, 5e-324, 1.7976931348623157e308, 2.0, 0.30000000000000004, -1e-320;
  predicted.channels = {{"angle", "rad"}};
  predicted.times = Eigen::Vector3d(0.0, 0.2 + 1e-9, 1.0 / 3.0);
  predicted.samples.resize(3, 1);
  predicted.samples << static_cast<double>(0.1F), 1e22, kNone;
  return {"rig", "sine.csv", 2, {{"measured", measured}, {"predicted", predicted}}};
}

/// Whether two columns have the same bits, whatever kind of NaN.
void expect_same_bits(const std::vector<double>& read, const std::vector<double>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (std::isnan(written[i]))
      EXPECT_TRUE(std::isnan(read[i])) << i;
    else
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i]), std::bit_cast<std::uint64_t>(written[i])) << i;
  }
}

const std::vector<std::string> kColumns = {"time [s]", "angle measured [rad]", "angle predicted [rad]",
                                           "rate measured [rad/s]"};
const std::vector<std::vector<double>> kValues = {{0.0, 0.1, 0.2 + 1e-9, 1.0 / 3.0},
                                                  {0.1, -1.0 / 3.0, 1.7976931348623157e308, 0.30000000000000004},
                                                  {static_cast<double>(0.1F), kNone, 1e22, kNone},
                                                  {kNone, 5e-324, 2.0, -1e-320}};

class Exports : public testing::Test {
 protected:
  std::string written(const std::string& name, const std::function<void(std::ostream&)>& write) const {
    std::ostringstream stream;
    write(stream);
    return folder_.write(name, stream.str()).string();
  }
  const TestFolder folder_;
};

TEST_F(Exports, AsCsvComeBackBitByBit) {
  std::ostringstream stream;
  write_trace_rows(some_trace(), *make_query_output(QueryFormat::csv, stream));
  FileReport report("sine.csv");
  const CsvFormat format = find_csv_format(stream.str(), {.time_column = kColumns[0]}, report);
  EXPECT_EQ(format.names, kColumns);
  CsvQuery query{.time_column = kColumns[0], .trial_column = "", .columns = {}};
  for (std::size_t i = 1; i < kColumns.size(); ++i) query.columns.push_back({kColumns[i]});
  const CsvTable table = read_csv_table(stream.str(), format, query, report);
  EXPECT_FALSE(report.has_problems());
  expect_same_bits(table.times, kValues[0]);
  for (std::size_t i = 1; i < kColumns.size(); ++i) expect_same_bits(table.columns.at(i - 1), kValues[i]);
}

TEST_F(Exports, AsNumpyComeBackBitByBit) {
  const std::string file =
      written("sine.npz", [](std::ostream& stream) { write_trace_rows(some_trace(), *make_numpy_output(stream)); });
  const FormatUnderTest format("numpy");
  EXPECT_EQ(format.columns(file), kColumns);
  for (std::size_t i = 0; i < kColumns.size(); ++i) expect_same_bits(format.column(file, kColumns[i]), kValues[i]);
}

TEST_F(Exports, AsJsonLinesComeBackBitByBit) {
  const std::string file = written("sine.jsonl", [](std::ostream& stream) {
    write_trace_rows(some_trace(), *make_query_output(QueryFormat::json_lines, stream));
  });
  const FormatUnderTest format("json_lines");
  EXPECT_THAT(format.columns(file), testing::UnorderedElementsAreArray(kColumns));
  for (std::size_t i = 0; i < kColumns.size(); ++i) expect_same_bits(format.column(file, kColumns[i]), kValues[i]);
}

TEST_F(Exports, AsMcapComeBackBitByBitAtTimesToTheNanosecond) {
  const std::string file = written("sine.mcap", [](std::ostream& stream) { write_mcap_trace(some_trace(), stream); });
  const FormatUnderTest format("rosbag2");
  EXPECT_THAT(format.columns(file, "/angle"), ElementsAre("t", "log_time", "time", "measured", "predicted"));
  expect_same_bits(format.column(file, "time", "/angle"), kValues[0]);
  expect_same_bits(format.column(file, "measured", "/angle"), kValues[1]);
  expect_same_bits(format.column(file, "predicted", "/angle"), kValues[2]);
  expect_same_bits(format.column(file, "measured", "/rate"), {5e-324, 2.0, -1e-320});
  EXPECT_THAT(format.column(file, "t", "/angle"), ElementsAre(0.0, 0.1, 0.200000001, 0.333333333));
}

TEST_F(Exports, AsMcapHaveAsManyChunksAsTheyNeed) {
  constexpr int kMessages = 100;
  const std::string file = written("many.mcap", [](std::ostream& stream) {
    McapWriter writer(stream, {{"/a", "a", "{}", {}}, {"/b", "b", "{}", {}}}, 300);
    for (int i = 0; i < kMessages; ++i)
      writer.add(i % 3 == 0 ? 1 : 0, 1'000'000 * static_cast<std::uint64_t>(i), "{\"i\":" + std::to_string(i) + "}");
    writer.finish();
  });
  const FormatUnderTest format("rosbag2");
  EXPECT_THAT(format.column(file, "i", "/a"), SizeIs(66));
  EXPECT_THAT(format.column(file, "i", "/b"), SizeIs(34));
  EXPECT_EQ(format.column(file, "i", "/b").back(), 99.0);
  const ReadRows read = format.read(file, {{"/a", {"i"}}});
  EXPECT_THAT(FormatUnderTest::texts(read.doubts), IsEmpty());
}

/// `exported.mcap` is this file as @mcap/core reads it with both of its readers (mcap_core/read_mcap.mjs).
TEST_F(Exports, AsMcapAreTheBytesThatAnotherProgramReads) {
  const std::string file = written("sine.mcap", [](std::ostream& stream) { write_mcap_trace(some_trace(), stream); });
  EXPECT_EQ(read_bytes(file), read_bytes(recorded_by_others("exported.mcap")));
}

TEST_F(Exports, OfATrialBeforeZeroAreMovedByWholeSeconds) {
  NamedTrace trace = some_trace();
  trace.parts.resize(1);
  trace.parts[0].series.times = Eigen::Vector4d(-1.5, -1.0, 0.0, 0.5);
  const std::string file = written("sine.mcap", [&](std::ostream& stream) { write_mcap_trace(trace, stream); });
  const FormatUnderTest format("rosbag2");
  EXPECT_THAT(format.column(file, "t", "/angle"), ElementsAre(0.5, 1.0, 2.0, 2.5));
  EXPECT_THAT(format.column(file, "time", "/angle"), ElementsAre(-1.5, -1.0, 0.0, 0.5));
}

/// Sizes as of files beyond 4 GiB, for small ones.
TEST_F(Exports, InZip64AreRead) {
  const std::string file = written("long.npz", [](std::ostream& stream) {
    ZipWriter archive(stream, 10);
    for (const char* name : {"a.npy", "b.npy"})
      archive.add(name, [](const ZipWriter::Sink& sink) {
        std::string text = "{'descr': '|u1', 'fortran_order': False, 'shape': (3,), }";
        text.resize(117, ' ');
        sink(std::string("\x93NUMPY\x01\x00\x76\x00", 10) + text + "\n");
        sink("\x01\x02\x03");
      });
    archive.finish();
  });
  const FormatUnderTest format("numpy");
  EXPECT_THAT(format.columns(file), ElementsAre("a", "b"));
  EXPECT_THAT(format.column(file, "b"), ElementsAre(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace lacuna
