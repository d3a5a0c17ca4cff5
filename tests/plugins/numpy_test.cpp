#include "plugins/recording_files.h"

#include <cstring>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsNan;

/// An .npy file with that header and those bytes.
std::string array_file(const std::string& header, const std::string& bytes, char version = 1) {
  std::string file("\x93NUMPY", 6);
  file += version;
  file += '\0';
  for (int shift = 0; shift < (version == 1 ? 16 : 32); shift += 8)
    file += static_cast<char>(header.size() >> shift & 0xff);
  return file + header + bytes;
}

std::string header_of(const std::string& type, const std::string& shape, bool fortran = false) {
  return "{'descr': " + type + ", 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
}

class Numpy : public testing::Test {
 protected:
  std::string file(const std::string& bytes) const { return folder_.write("run.npy", bytes).string(); }
  std::vector<double> values(const std::string& type, const std::string& bytes, const std::string& shape) const {
    return format_.column(file(array_file(header_of("'" + type + "'", shape), bytes)), "[0]");
  }
  const TestFolder folder_;
  const FormatUnderTest format_{"numpy"};
};

TEST_F(Numpy, ReadsArchivesOfNumpy) {
  const std::string run = recorded_by_others("run.npz");
  EXPECT_THAT(format_.columns(run), ElementsAre("t", "q[0]", "q[1]", "tau[0]", "tau[1]"));
  EXPECT_THAT(format_.column(run, "q[1]"), ElementsAre(0.25, 0.75, 1.25, 1.75, 2.25));
  EXPECT_THAT(format_.column(run, "tau[0]"), ElementsAre(0.0, -0.5, -1.0, -1.5, -2.0)) << "in Fortran order";
  EXPECT_THAT(FormatUnderTest::texts(format_.contents(run).remarks),
              ElementsAre(HasSubstr("`rate` is left out: it is a single value"),
                          HasSubstr("`name` is left out: it contains no numbers"),
                          HasSubstr("`mass` is left out: it has 3 rows, but the others have 5")));
  EXPECT_THAT(format_.column(recorded_by_others("run_compressed.npz"), "q[1]"),
              ElementsAre(0.25, 0.75, 1.25, 1.75, 2.25));
}

TEST_F(Numpy, ReadsFieldsOfStructuredTypesByPath) {
  const std::string run = recorded_by_others("structured.npy");
  EXPECT_THAT(format_.columns(run), ElementsAre("stamp", "joint.q[0]", "joint.q[1]", "joint.on", "counts"));
  EXPECT_THAT(format_.column(run, "joint.q[0]"), ElementsAre(0.5, 1.5, 2.5));
  EXPECT_THAT(format_.column(run, "joint.on"), ElementsAre(1.0, 0.0, 1.0));
  EXPECT_THAT(format_.column(run, "counts"), ElementsAre(1.0, 65535.0, 3.0));
  const ReadRows read = format_.read(run, {{"", {"stamp"}}});
  EXPECT_EQ(read.tables.at(0).origins.at(0), 1.7e9);
  EXPECT_THAT(read.tables.at(0).columns.at(0), ElementsAre(1e-9, 0.5, 1.0));
}

/// A field called like the path of another one.
TEST_F(Numpy, ReadsTheFirstOfTwoFieldsWithOnePath) {
  const std::string twice =
      file(array_file(header_of("[('q[1]', '|u1'), ('q', '|u1', (2,))]", "(2,)"), "\1\2\3\4\5\6"));
  EXPECT_THAT(format_.columns(twice), ElementsAre("q[1]", "q[0]"));
  EXPECT_THAT(format_.column(twice, "q[1]"), ElementsAre(1.0, 4.0));
  EXPECT_THAT(FormatUnderTest::texts(format_.contents(twice).remarks),
              ElementsAre("column `q[1]` occurs more than once; the first one is used"));
}

TEST_F(Numpy, ReadsFortranOrderOfThreeDimensions) {
  const std::string run = recorded_by_others("fortran.npy");
  EXPECT_THAT(format_.columns(run), ElementsAre("[0][0]", "[0][1]", "[1][0]", "[1][1]"));
  EXPECT_THAT(format_.column(run, "[0][1]"), ElementsAre(-5.0, -1.0, 3.0));
  EXPECT_THAT(format_.column(run, "[1][0]"), ElementsAre(-4.0, 0.0, 4.0));
  const ReadRows first = format_.read(run, {{"", {"[1][1]"}, 2}});
  EXPECT_THAT(first.tables.at(0).columns.at(0), ElementsAre(-3.0, 1.0));
}

TEST_F(Numpy, ReadsEveryTypeOfNumber) {
  using namespace std::string_literals;
  EXPECT_THAT(values("<f2", "\x00\x3c\x00\xc0\x01\x00\x00\x7e"s, "(4,)"), ElementsAre(1.0, -2.0, 0x1p-24, IsNan()));
  EXPECT_THAT(values(">f8", "\x3f\xf8\x00\x00\x00\x00\x00\x00"s, "(1,)"), ElementsAre(1.5));
  EXPECT_THAT(values("<i2", "\xfe\xff"s, "(1,)"), ElementsAre(-2.0));
  EXPECT_THAT(values("|u1", "\xfe"s, "(1,)"), ElementsAre(254.0));
  EXPECT_THAT(values("<u8", "\xff\xff\xff\xff\xff\xff\xff\xff"s, "(1,)"), ElementsAre(18446744073709551615.0));
  EXPECT_THAT(values("<M8[ms]", "\xdc\x05\0\0\0\0\0\0\0\0\0\0\0\0\0\x80"s, "(2,)"), ElementsAre(1.5, IsNan()));
  EXPECT_THAT(format_.column(file(array_file(header_of("'<u2'", "(1, 1)"), "\x02\x01"s, 2)), "[0]"),
              ElementsAre(258.0));
}

TEST_F(Numpy, RefusesWithTheReason) {
  const auto problem = [&](const std::string& bytes) { return format_.problems(file(bytes)); };
  EXPECT_THAT(problem(""), ElementsAre(HasSubstr("is not an .npy file")));
  EXPECT_THAT(problem("t,q\n0,1\n1,2\n"), ElementsAre(HasSubstr("is not an .npy file")));
  EXPECT_THAT(problem(array_file(header_of("'<f8'", "(3,)"), std::string(17, '\0'))),
              ElementsAre(HasSubstr("ends after 2 of 3 rows")));
  EXPECT_THAT(problem(array_file(header_of("'<f8'", "(1000000000000000,)"), std::string(16, '\0'))),
              ElementsAre(HasSubstr("ends after 2 of 1000000000000000 rows")));
  EXPECT_THAT(problem(array_file(header_of("'<f8'", "(2, 4611686018427387904, 4)"), "")),
              ElementsAre(HasSubstr("more than 4096 numbers per row")));
  EXPECT_THAT(problem(array_file(header_of("'|O'", "(3,)"), "")), ElementsAre(HasSubstr("Python objects")));
  EXPECT_THAT(problem(array_file(header_of("'<c16'", "(3,)"), "")), ElementsAre(HasSubstr("no numbers")));
  EXPECT_THAT(problem(array_file(header_of("'<f8'", "()"), std::string(8, '\0'))),
              ElementsAre(HasSubstr("is a single value")));
  EXPECT_THAT(problem(array_file(header_of("[('a', '<f8', (100000000,))]", "(3,)"), "")),
              ElementsAre(HasSubstr("more than 16 MiB")));
  EXPECT_THAT(problem(array_file("{'descr': '<f8', 'shape': (3,)}", "")),
              ElementsAre(HasSubstr("its header has no descr, fortran_order or shape")));
  EXPECT_THAT(problem(array_file(header_of("'<f8'", "(3,)"), "", 9)), ElementsAre(HasSubstr("version 9")));
  EXPECT_THAT(problem("PK\x03\x04 and nothing else that an archive has"),
              ElementsAre(HasSubstr("no directory at its end")));
}

TEST_F(Numpy, FindsDamageByTheChecksum) {
  std::string bytes = read_bytes(recorded_by_others("run.npz"));
  const std::size_t number = bytes.find(std::string("\0\0\0\0\0\0\xd0\x3f", 8));
  ASSERT_NE(number, std::string::npos) << "the number 0.25";
  bytes[number + 6] = '\0';
  const std::string run = folder_.write("run.npz", bytes).string();
  EXPECT_THAT(format_.problems(run), ElementsAre(AllOf(HasSubstr("array `q`"), HasSubstr("checksum"))));
}

TEST_F(Numpy, AreReadOrRefusedHoweverTheyAreDamaged) {
  EXPECT_GT(read_damaged(format_, read_bytes(recorded_by_others("run_compressed.npz")), "run.npz"), 0);
  EXPECT_GT(read_damaged(format_, read_bytes(recorded_by_others("structured.npy")), "run.npy"), 0);
}

}  // namespace
}  // namespace lacuna
