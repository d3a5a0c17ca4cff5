#include "plugins/recording_files.h"

namespace lacuna {
namespace {

using namespace std::string_literals;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

class Mat : public testing::Test {
 protected:
  std::string file(const std::string& bytes) const { return folder_.write("run.mat", bytes).string(); }
  const TestFolder folder_;
  const FormatUnderTest format_{"mat"};
};

std::string number(std::uint32_t value, bool big_endian) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * (big_endian ? 3 - i : i)) & 0xff);
  return bytes;
}

std::string element(std::uint32_t type, const std::string& data, bool big_endian) {
  const auto size = static_cast<std::uint32_t>(data.size());
  return number(type, big_endian) + number(size, big_endian) + data + std::string((8 - size % 8) % 8, '\0');
}

std::string header(bool big_endian) {
  std::string text = "MATLAB 5.0 MAT-file, written by a test";
  text.resize(124, ' ');
  return text + (big_endian ? "\1\0MI"s : "\0\1IM"s);
}

/// A row of whole numbers of one byte in the class double, called `name`.
std::string row(const std::string& name, const std::string& numbers, bool big_endian, std::uint32_t columns) {
  return element(14,
                 element(6, number(6, big_endian) + number(0, big_endian), big_endian) +
                     element(5, number(1, big_endian) + number(columns, big_endian), big_endian) +
                     element(1, name, big_endian) + element(2, numbers, big_endian),
                 big_endian);
}

TEST_F(Mat, ReadsStructuresByPath) {
  const std::string run = recorded_by_others("run.mat");
  EXPECT_THAT(format_.columns(run), UnorderedElementsAre("log.time", "log.q(:,1)", "log.q(:,2)", "log.wide(1,:)",
                                                         "log.wide(2,:)", "log.counts", "log.inner.on"));
  EXPECT_THAT(format_.column(run, "log.q(:,2)"), ElementsAre(0.25, 0.75, 1.25, 1.75, 2.25));
  EXPECT_THAT(format_.column(run, "log.wide(2,:)"), ElementsAre(-0.25, -0.75, -1.25, -1.75, -2.25));
  EXPECT_THAT(format_.column(run, "log.counts"), ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0));
  EXPECT_THAT(format_.column(run, "log.inner.on"), ElementsAre(1.0, 0.0, 1.0, 0.0, 1.0));
  EXPECT_THAT(FormatUnderTest::texts(format_.contents(run).remarks),
              UnorderedElementsAre(HasSubstr("`log.label` is left out: it is text"),
                                   HasSubstr("`gains` is left out: it has 2 × 3 numbers, but the others have 5")));
}

TEST_F(Mat, ReadsCompressedVariables) {
  const std::string run = recorded_by_others("run_compressed.mat");
  EXPECT_THAT(format_.columns(run), UnorderedElementsAre("time", "q(:,1)", "q(:,2)"));
  EXPECT_THAT(format_.column(run, "time"), ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0));
  EXPECT_THAT(format_.column(run, "q(:,1)"), ElementsAre(0.0, 0.5, 1.0, 1.5, 2.0));
  EXPECT_THAT(FormatUnderTest::texts(format_.contents(run).remarks),
              UnorderedElementsAre(HasSubstr("`cells` is left out: it is a cell array"),
                                   HasSubstr("`z` is left out: it is complex"),
                                   HasSubstr("`list` is left out: it is a list of structures")));
}

TEST_F(Mat, ReadsBothByteOrders) {
  for (const bool big_endian : {false, true})
    EXPECT_THAT(format_.column(file(header(big_endian) + row("q", "\1\2\xff"s, big_endian, 3)), "q"),
                ElementsAre(1.0, 2.0, 255.0))
        << big_endian;
}

TEST_F(Mat, ReadsTheFirstOfTwoVariablesWithOneName) {
  const std::string twice = file(header(false) + row("q", "\1\2"s, false, 2) + row("q", "\3\4"s, false, 2));
  EXPECT_THAT(format_.columns(twice), ElementsAre("q"));
  EXPECT_THAT(format_.column(twice, "q"), ElementsAre(1.0, 2.0));
  EXPECT_THAT(FormatUnderTest::texts(format_.contents(twice).remarks),
              ElementsAre("column `q` occurs more than once; the first one is used"));
}

TEST_F(Mat, ReadsNoMoreRowsThanAreWanted) {
  const ReadRows read = format_.read(recorded_by_others("run.mat"), {{"", {"log.wide(1,:)", "log.q(:,1)"}, 2}});
  EXPECT_THAT(read.tables.at(0).columns.at(0), ElementsAre(0.0, -0.5));
  EXPECT_THAT(read.tables.at(0).columns.at(1), ElementsAre(0.0, 0.5));
}

TEST_F(Mat, RefusesWithTheReason) {
  const auto problem = [&](const std::string& bytes) { return format_.problems(file(bytes)); };
  EXPECT_THAT(problem("MATLAB 7.3 MAT-file, Platform: GLNXA64"), ElementsAre(HasSubstr("'-v7'")));
  EXPECT_THAT(problem("t,q\n0,1\n"), ElementsAre(HasSubstr("is not a MAT file of version 5")));
  EXPECT_THAT(problem(header(false) + row("q", "\1\2\3"s, false, 4)),
              ElementsAre(HasSubstr("has 3 numbers in `q`, which should have 4")));
  EXPECT_THAT(problem(header(false) + row("q", "\1\2\3"s, false, 3).substr(0, 40)),
              ElementsAre(HasSubstr("the file is incomplete or damaged")));
  EXPECT_THAT(problem(header(false) + number(15, false) + number(8, false) + "no zlib."),
              ElementsAre(HasSubstr("compressed data are damaged")));
  EXPECT_THAT(problem(header(false) + number(14, false) + number(0xffffffff, false)),
              ElementsAre(HasSubstr("4294967295 bytes where 0 are left")));
}

TEST_F(Mat, AreReadOrRefusedHoweverTheyAreDamaged) {
  EXPECT_GT(read_damaged(format_, read_bytes(recorded_by_others("run.mat")), "run.mat"), 50);
  EXPECT_GT(read_damaged(format_, read_bytes(recorded_by_others("run_compressed.mat")), "run.mat"), 50);
}

}  // namespace
}  // namespace lacuna
