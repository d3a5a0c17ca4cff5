#include "end_to_end/guide.h"

#include "end_to_end/printed_lines.h"

#include <algorithm>
#include <fstream>
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
