#include "runs/random_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <stdexcept>

namespace hidden_effects {
namespace {

const std::vector<CommandRange> kMotor = {{"motor", "N*m", -0.4, 0.3}};
constexpr int kDrawn = 300;

/// What a line says of one drive.
struct ReadLine {
  std::string shape;
  double amplitude = 0.0, centre = 0.0, low = 0.0, high = 0.0, duration = 0.0;
  bool seeded = false;
};

ReadLine read_line(const std::string& line) {
  static const std::regex kForm(
      "(\\w+) motor ([0-9.e-]+) N\\*m(?: around ([0-9.e-]+) N\\*m)? ([0-9.]+)(?:-([0-9.]+))? Hz ([0-9.]+) s"
      "( seed [0-9]{1,3})?");
  std::smatch found;
  if (!std::regex_match(line, found, kForm)) throw std::runtime_error(line);
  const double low = std::stod(found[4]);
  return {found[1],
          std::stod(found[2]),
          found[3].matched ? std::stod(found[3]) : 0.0,
          low,
          found[5].matched ? std::stod(found[5]) : low,
          std::stod(found[6]),
          found[7].matched};
}

TEST(RandomTest, StaysWithinTheRecordedCommandsAndTheBand) {
  Draw draw(7, 1);
  std::set<std::string> shapes;
  for (int i = 0; i < kDrawn; ++i) {
    const std::string text = random_test(kMotor, 5.0, draw);
    const ReadLine line = read_line(text);
    shapes.insert(line.shape);
    EXPECT_GT(line.amplitude, 0.0) << text;
    EXPECT_LE(line.centre + line.amplitude, 0.3 + 1e-12) << text;
    EXPECT_GE(line.centre - line.amplitude, -0.4 - 1e-12) << text;
    EXPECT_GE(line.low, 0.2) << text;
    EXPECT_LE(line.low, line.high) << text;
    EXPECT_LE(line.high, 5.0) << text;
    EXPECT_EQ(line.duration, 5.0) << text;
    EXPECT_EQ(line.seeded, line.shape == "multisine" || line.shape == "steps") << text;
  }
  EXPECT_EQ(shapes.size(), 4U);
}

TEST(RandomTest, IsTheSameForTheSameSeed) {
  Draw one(7, 1), same(7, 1), other(8, 1);
  const std::string line = random_test(kMotor, 5.0, one);
  EXPECT_EQ(random_test(kMotor, 5.0, same), line);
  EXPECT_NE(random_test(kMotor, 5.0, other), line);
}

TEST(RandomTest, DrivesEveryDrive) {
  Draw draw(7, 1);
  const std::string line = random_test({{"hip", "N*m", -1.0, 1.0}, {"knee", "rad", 0.0, 0.5}}, 2.5, draw);
  EXPECT_THAT(line, testing::ContainsRegex("^[a-z]+ hip .* 2.5 s.*, [a-z]+ knee .* around .* rad .* 2.5 s"));
}

TEST(RandomTest, NeedsARange) {
  Draw draw(7, 1);
  EXPECT_THROW(random_test({{"motor", "N*m", 0.0, 0.0}}, 5.0, draw), std::runtime_error);
}

TEST(TestLine, TellsItsDuration) {
  EXPECT_EQ(duration_of_test("triangle motor 0.3 N*m 0.1 Hz 20 s"), 20.0);
  EXPECT_EQ(duration_of_test("chirp hip 1 N 0.1-3 Hz 2.5 s, steps knee 0.4 rad 0.5 Hz 2.5 s seed 3"), 2.5);
  EXPECT_THROW(duration_of_test("triangle motor 0.3 N*m 0.1 Hz"), std::runtime_error);
}

TEST(TestLine, TakesAnotherSeedWhereItHasOne) {
  Draw draw(7, 1);
  const std::string line = "chirp hip 1 N 0.1-3 Hz 2 s, steps knee 0.4 rad 0.5 Hz 2 s seed 3";
  const std::string other = reseeded_test(line, draw);
  EXPECT_THAT(other, testing::ContainsRegex("^chirp hip 1 N 0.1-3 Hz 2 s, steps knee 0.4 rad 0.5 Hz 2 s seed [0-9]+$"));
  EXPECT_NE(other, line);
  EXPECT_EQ(reseeded_test("triangle motor 0.3 N*m 0.1 Hz 20 s", draw), "triangle motor 0.3 N*m 0.1 Hz 20 s");
}

}  // namespace
}  // namespace hidden_effects
