#include "experiment_design/test_line.h"

#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <lacuna/error.h>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kRelative = 1e-15;

class TestLineTest : public testing::Test {
 protected:
  TestLineTest() {
    space_.actuators = {{"motor", "N*m"}, {"slide", "m"}};
    space_.lower = {-0.5, 0.1};
    space_.upper = {0.5, 0.4};
    space_.control_period = 0.002;
    space_.duration = 20.0;
  }
  void expect_refused(const std::string& line, const std::string& words) const {
    EXPECT_THAT([&] { parse_test_line(space_, line); }, ThrowsMessage<Error>(AllOf(HasSubstr(words), HasSubstr(line))));
  }
  TestSpace space_;
};

TEST_F(TestLineTest, IsWhatAPersonTypes) {
  const TestLine triangle = parse_test_line(space_, "triangle motor 0.3 N*m 0.1 Hz 20 s");
  EXPECT_EQ(triangle.duration, 20.0);
  EXPECT_EQ(triangle.genome, (Genome{3.0, 0.3, 0.0, 0.1, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0}));
  const TestLine both = parse_test_line(
      space_, "multisine motor 200 mN*m 0.1-5 Hz 20000 ms seed 3,  chirp slide 50 mm around 0.25 m 0.2-3 Hz 20 s");
  ASSERT_EQ(both.genome.size(), 12U);
  EXPECT_NEAR(both.genome[1], 0.2, kRelative);
  EXPECT_EQ(both.genome[5], 3.0);
  EXPECT_NEAR(both.genome[7], 0.05, kRelative);
  EXPECT_EQ(both.genome[8], 0.25);
  EXPECT_EQ(both.genome[10], 3.0);
}

TEST_F(TestLineTest, EveryGenomeReadsBackAsItself) {
  const TestEncoding& encoding = built_catalog().get<TestEncoding>("command_series");
  std::vector<double> parameters;
  for (const ParameterDeclaration& declaration : encoding.parameters()) parameters.push_back(declaration.default_value);
  const GenomeLayout layout = encoding.layout(space_, parameters);
  for (std::uint64_t key = 0; key < 500; ++key) {
    RandomStream random(std::vector<std::uint64_t>{key});
    const Genome genome = sayable(space_, encoding.random(layout, random));
    const std::string line = test_line(space_, genome);
    const TestLine read = parse_test_line(space_, line);
    EXPECT_EQ(read.genome, genome) << line;
    EXPECT_EQ(read.duration, space_.duration);
    EXPECT_EQ(test_line(space_, read.genome), line);
    EXPECT_EQ(sayable(space_, genome), genome) << line;
  }
}

TEST_F(TestLineTest, WhatIsSaidIsLongEnoughAndSlowEnough) {
  space_.duration = 3.0;           // 1/3 Hz has no three digits
  space_.control_period = 0.0006;  // and 416.67 Hz is the fastest
  const Genome said = sayable(space_, {2.0, 0.3, 0.0, 1e-6, 1e6, 0.0, 0.0, 0.0, 0.2, 1.0, 1.0, 0.0});
  EXPECT_EQ(test_line(space_, said), "chirp motor 0.3 N*m 0.334-416 Hz 3 s");
  EXPECT_EQ(parse_test_line(space_, test_line(space_, said)).genome, said);
  EXPECT_EQ(parse_test_line(space_, "chirp motor 0.3 N*m 1e-2-4e-2 Hz 1e5 ms").duration, 100.0);
}

TEST_F(TestLineTest, ABandOfOneFrequencyIsASine) {
  const Genome rest = {0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
  for (const double shape : {0.0, 2.0}) {
    Genome genome = {shape, 0.3, 0.0, 0.7199, 0.7201, 3.0};
    genome.insert(genome.end(), rest.begin(), rest.end());
    const Genome said = sayable(space_, genome);
    EXPECT_EQ(test_line(space_, said), "multisine motor 0.3 N*m 0.72 Hz 20 s seed 3");
    EXPECT_EQ(parse_test_line(space_, test_line(space_, said)).genome, said);
  }
}

TEST_F(TestLineTest, SaysWhatIsWrongAndWhatWouldBeRight) {
  expect_refused("triangel motor 0.3 N*m 0.1 Hz 20 s", "did you mean \"triangle\"?");
  expect_refused("triangle moter 0.3 N*m 0.1 Hz 20 s", "did you mean \"motor\"?");
  expect_refused("triangle motor 0.3 rad 0.1 Hz 20 s", "with a unit such as N*m");
  expect_refused("triangle motor 0.3 0.1 Hz 20 s", "\"0.3 N*m\"");
  expect_refused("triangle motor", "the amplitude must be a number with a unit");
  expect_refused("triangle motor 0.3 N*m", "the frequency must be in Hz");
  expect_refused("triangle motor 0.3 N*m 0.1 Hz", "the line ends here");
  expect_refused("triangle motor 0.9 N*m 0.1 Hz 20 s", "-0.5 to 0.5 N*m; reduce the amplitude to 0.5 N*m");
  expect_refused("triangle motor 0.4 N*m around 0.2 N*m 0.1 Hz 20 s", "reduce the amplitude to 0.3 N*m");
  expect_refused("triangle slide 0.1 m 0.1 Hz 20 s", "around");
  expect_refused("triangle motor -0.3 N*m 0.1 Hz 20 s", "above 0");
  expect_refused("triangle motor nan N*m 0.1 Hz 20 s", "not finite");
  expect_refused("triangle motor 0.3 N*m 0.1-5 Hz 20 s", "one frequency");
  expect_refused("chirp motor 0.3 N*m 0.1 Hz 20 s", "two frequencies");
  expect_refused("chirp motor 0.3 N*m 5-0.1 Hz 20 s", "lower frequency first");
  expect_refused("chirp motor 0.3 N*m 0.1-200 Hz 20 s", "use 125 Hz or less");
  expect_refused("triangle motor 0.3 N*m 0.1 Hz 2 s", "use 10 s or more");
  expect_refused("triangle motor 0.3 N*m 0.1 Hz 20 s seed 3", "\"seed\" is not expected here");
  expect_refused("steps motor 0.3 N*m 1 Hz 20 s seed 3.5", "whole number");
  expect_refused("steps motor 0.3 N*m 1 Hz 1e5 s", "a million");
  expect_refused("steps motor 0.3 N*m 1 Hz 20 s, steps slide 0.1 m around 0.2 m 1 Hz 10 s", "one duration");
  expect_refused("steps motor 0.3 N*m 1 Hz 20 s, chirp motor 0.1 N*m 1-2 Hz 20 s", "appears twice");
  EXPECT_THAT([&] { parse_test_line(space_, ""); }, ThrowsMessage<Error>(HasSubstr("empty")));
}

TEST_F(TestLineTest, TellsOfEveryActuatorAtOnce) {
  expect_refused("wave motor 0.3 N*m 1 Hz 20 s, steps slide 3 m around 0.2 m 1 Hz 20 s", "unknown shape \"wave\"");
  expect_refused("wave motor 0.3 N*m 1 Hz 20 s, steps slide 3 m around 0.2 m 1 Hz 20 s", "exceeds the limits of slide");
}

}  // namespace
}  // namespace lacuna
