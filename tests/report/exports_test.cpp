#include "report/exports/column_spool.h"
#include "report/exports/npy_column.h"
#include "report/exports/numpy_output.h"
#include "report/exports/trace_rows.h"
#include "report/exports/zip_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace lacuna {
namespace {

using namespace std::string_literals;
using testing::ElementsAre;

/// An array as `numpy.save` writes it.
std::string array_of(const std::vector<Cell>& cells) {
  NpyColumn column;
  for (const Cell& cell : cells) column.see(cell);
  std::string bytes = column.header();
  for (const Cell& cell : cells) bytes += column.bytes_of(cell);
  return bytes;
}

std::string description_of(const std::vector<Cell>& cells) {
  const std::string bytes = array_of(cells);
  const std::size_t begin = bytes.find("'descr': '") + 10;
  return bytes.substr(begin, bytes.find('\'', begin) - begin);
}

/// What NumPy 1.24 writes of array(["a", "µm"]), array([7, -2]) and array([1.5, nan]).
TEST(NpyColumn, HasTheBytesThatNumpyWrites) {
  const auto expected = [](const std::string& type, const std::string& numbers) {
    return "\x93NUMPY\x01\x00v\x00"s + "{'descr': '" + type + "', 'fortran_order': False, 'shape': (2,), }" +
           std::string(60, ' ') + "\n" + numbers;
  };
  EXPECT_EQ(array_of({1.5, std::monostate{}}),
            expected("<f8", "\x00\x00\x00\x00\x00\x00\xf8\x3f\x00\x00\x00\x00\x00\x00\xf8\x7f"s));
  EXPECT_EQ(array_of({std::int64_t{7}, std::int64_t{-2}}),
            expected("<i8", "\x07\x00\x00\x00\x00\x00\x00\x00\xfe\xff\xff\xff\xff\xff\xff\xff"s));
  EXPECT_EQ(array_of({"a"s, "µm"s}), expected("<U2", "a\x00\x00\x00\x00\x00\x00\x00\xb5\x00\x00\x00m\x00\x00\x00"s));
}

TEST(NpyColumn, HasTheNarrowestTypeThatHoldsEveryCell) {
  const Cell none, whole = std::int64_t{3}, real = 0.5, text = "abc"s, large = (std::int64_t{1} << 53) + 1;
  EXPECT_EQ(description_of({whole, large}), "<i8");
  EXPECT_EQ(description_of({whole, none}), "<f8");
  EXPECT_EQ(description_of({whole, real}), "<f8");
  EXPECT_EQ(description_of({large, none}), "<U24") << "a float64 does not hold it";
  EXPECT_EQ(description_of({text, none}), "<U3");
  EXPECT_EQ(description_of({text, real}), "<U24");
  EXPECT_EQ(description_of({Blob{5}}), "<U9");
  EXPECT_EQ(description_of({none}), "<f8");
  EXPECT_EQ(description_of({}), "<f8");
}

TEST(ColumnSpool, GivesEveryCellBackFromMemoryAndFromItsFile) {
  ColumnSpool spool(2, 100);
  constexpr int kRows = 1000;
  for (int i = 0; i < kRows; ++i) {
    spool.add(0, i % 7 == 0 ? Cell() : Cell(std::int64_t{i}));
    spool.add(1, i % 2 == 0 ? Cell(0.1 * i) : Cell("row " + std::to_string(i)));
  }
  for (int pass = 0; pass < 2; ++pass) {
    int row = 0;
    spool.visit(1, [&](const Cell& cell) {
      EXPECT_EQ(cell, row % 2 == 0 ? Cell(0.1 * row) : Cell("row " + std::to_string(row)));
      ++row;
    });
    EXPECT_EQ(row, kRows);
    row = 0;
    spool.visit(0, [&](const Cell& cell) {
      EXPECT_EQ(cell, row % 7 == 0 ? Cell() : Cell(std::int64_t{row}));
      ++row;
    });
    EXPECT_EQ(row, kRows);
  }
}

TEST(ZipWriter, WritesStoredMembersWithTheirChecksums) {
  std::ostringstream stream;
  ZipWriter archive(stream);
  archive.add("a", [](const ZipWriter::Sink& sink) {
    sink("12345");
    sink("6789");
  });
  archive.finish();
  const std::string bytes = stream.str();
  EXPECT_EQ(bytes.substr(0, 4), "PK\x03\x04");
  EXPECT_EQ(bytes.substr(14, 4), "\x26\x39\xf4\xcb"s) << "the check value of CRC-32";
  EXPECT_EQ(bytes.substr(30, 10), "a123456789");
  EXPECT_EQ(bytes.size(), 30 + 10 + 46 + 1 + 22U);
}

/// Keeps the rows that it is given.
class KeptRows : public QueryOutput {
 public:
  void begin(const std::vector<std::string>& columns) override { names = columns; }
  void row(const std::vector<Cell>& cells) override { rows.push_back(cells); }
  void end() override { ended = true; }
  std::vector<std::string> names;
  std::vector<std::vector<Cell>> rows;
  bool ended = false;
};

TimeSeries series_of(const std::vector<Channel>& channels, const std::vector<double>& times,
                     const std::vector<double>& values) {
  TimeSeries series{
      channels, Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size())), {}};
  series.samples = Eigen::Map<const TimeSeries::Samples>(values.data(), series.times.size(),
                                                         static_cast<Eigen::Index>(channels.size()));
  return series;
}

TEST(TraceRows, HaveMeasuredBesidePredictedAtEveryTime) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const NamedTrace trace{
      "rig",
      "sine.csv",
      2,
      {{"measured", series_of({{"angle", "rad"}, {"rate", "rad/s"}}, {0.0, 0.5, 1.0}, {0.1, 1.0, none, 2.0, 0.3, 3.0})},
       {"predicted", series_of({{"angle", "rad"}}, {0.0, 1.0, 1.5}, {0.11, 0.31, 0.41})}}};
  KeptRows output;
  write_trace_rows(trace, output);
  EXPECT_THAT(output.names,
              ElementsAre("time [s]", "angle measured [rad]", "angle predicted [rad]", "rate measured [rad/s]"));
  const Cell null;
  EXPECT_THAT(output.rows, ElementsAre(ElementsAre(Cell(0.0), Cell(0.1), Cell(0.11), Cell(1.0)),
                                       ElementsAre(Cell(0.5), null, null, Cell(2.0)),
                                       ElementsAre(Cell(1.0), Cell(0.3), Cell(0.31), Cell(3.0)),
                                       ElementsAre(Cell(1.5), null, Cell(0.41), null)));
  EXPECT_TRUE(output.ended);
}

}  // namespace
}  // namespace lacuna
