#include "end_to_end/guide.h"

#include "end_to_end/printed_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace lacuna {
namespace {

const std::string kExitCode = "(exit code ";

/// What stands left of the equals sign, without the mark of a comment; empty where there is none.
std::string key_of(const std::string& line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return {};
  std::string key = line.substr(0, equals);
  key.erase(0, key.find_first_not_of("# "));
  key.erase(key.find_last_not_of(' ') + 1);
  return key;
}

void take_exit_code(GuideStep& step) {
  while (!step.lines.empty() && step.lines.back().empty()) step.lines.pop_back();
  if (step.lines.empty() || !step.lines.back().starts_with(kExitCode)) return;
  step.exit_code = std::stoi(step.lines.back().substr(kExitCode.size()));
  step.lines.pop_back();
}

}  // namespace

std::vector<GuideStep> guide_steps(const std::string& markdown) {
  const std::string kEdit = "```toml ";
  std::vector<GuideStep> steps;
  enum class Block { none, console, edit } block = Block::none;
  int number = 0;
  for (const std::string& line : lines_of(markdown)) {
    ++number;
    if (line.starts_with("```")) {
      block = line == "```console" ? Block::console : line.starts_with(kEdit) ? Block::edit : Block::none;
      if (block == Block::edit) steps.push_back({number, "", line.substr(kEdit.size()), {}});
    } else if (block == Block::console && line.starts_with("$ ")) {
      steps.push_back({number, line.substr(2), "", {}});
    } else if (block != Block::none && !steps.empty()) {
      steps.back().lines.push_back(line);
    }
  }
  std::for_each(steps.begin(), steps.end(), take_exit_code);
  return steps;
}

std::vector<std::string> words_of_picture(const std::string& svg) {
  static const std::regex kText("<text[^>]*>(?:<tspan[^>]*>)?([^<]*)");
  std::vector<std::string> words;
  for (std::sregex_iterator found(svg.begin(), svg.end(), kText), end; found != end; ++found)
    words.push_back((*found)[1]);
  return words;
}

namespace {

/// Without what a run says of its progress every ten seconds: a slow machine says it where a fast one does not.
std::vector<std::string> without_progress(std::vector<std::string> lines) {
  std::erase_if(lines, [](const std::string& line) { return line.find(" evaluations/s · ") != std::string::npos; });
  return lines;
}

}  // namespace

void follow_guide(const std::string& document, const Program& program, const std::string& until) {
  const std::string text = source_file(document);
  const std::vector<GuideStep> steps = guide_steps(text.substr(0, until.empty() ? text.size() : text.find(until)));
  ASSERT_FALSE(steps.empty()) << document << " has no steps";
  for (const GuideStep& step : steps) {
    SCOPED_TRACE(document + ":" + std::to_string(step.line));
    if (!step.file.empty()) {
      program.write(step.file, edited(program.read(step.file), step.lines));
      continue;
    }
    const Outcome outcome = program.shell(step.command);
    EXPECT_EQ(outcome.exit_code, step.exit_code) << outcome.errors;
    const std::string& printed = outcome.exit_code == 0 ? outcome.output : outcome.errors;
    EXPECT_EQ(difference(step.lines, without_progress(lines_of(printed)), kFigureTolerance), "") << printed;
  }
}

std::string edited(const std::string& text, const std::vector<std::string>& lines) {
  std::vector<std::string> all = lines_of(text);
  auto last = all.end();
  for (const std::string& line : lines) {
    const auto old =
        std::find_if(all.begin(), all.end(), [&](const auto& other) { return key_of(other) == key_of(line); });
    if (old != all.end()) {
      *old = line;
      last = old;
    } else if (last != all.end()) {
      last = all.insert(last + 1, line);
    } else {
      throw std::runtime_error("no line sets " + key_of(line));
    }
  }
  std::string result;
  for (const std::string& line : all) result += line + "\n";
  return result;
}

std::string source_file(const std::string& name) {
  std::ifstream in(std::string(LACUNA_SOURCE_DIRECTORY "/") + name);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace lacuna
