#include "end_to_end/console_block.h"
#include "end_to_end/program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace lacuna {
namespace {

constexpr double kFigureTolerance = 0.05;  // of a figure in a document: compilers and processors differ in last digits

std::string document(const std::string& name) {
  std::ifstream in(std::string(LACUNA_SOURCE_DIRECTORY "/") + name);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class Document : public testing::TestWithParam<const char*> {};

TEST_P(Document, PrintsWhatItSays) {
  const std::vector<ConsoleStep> steps = console_steps(document(GetParam()));
  ASSERT_FALSE(steps.empty()) << GetParam() << " has no console block";
  const Program program;
  program.copy_servo_pendulum();
  for (const ConsoleStep& step : steps) {
    SCOPED_TRACE(std::string(GetParam()) + ":" + std::to_string(step.line));
    ASSERT_EQ(step.words.front(), "lacuna");
    const Outcome outcome = program.run({step.words.begin() + 1, step.words.end()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(difference(step.output, lines_of(outcome.output), kFigureTolerance), "") << outcome.output;
  }
}

INSTANTIATE_TEST_SUITE_P(Documents, Document, testing::Values("README.md"),
                         [](const auto& document) { return std::to_string(document.index); });

}  // namespace
}  // namespace lacuna
