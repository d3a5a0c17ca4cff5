#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// A command of a document and what it is said to print.
struct ConsoleStep {
  int line = 0;  ///< of the command, from 1
  std::vector<std::string> words;
  std::vector<std::string> output;
};

/// The steps of all ```console blocks of a Markdown text: a line that begins with "$ " is a command, the
/// lines after it are its output.
std::vector<ConsoleStep> console_steps(const std::string& markdown);

/// What differs between what a document says and what was printed; empty: nothing. Runs of blanks count
/// as one, bars and the length of rules are not compared, numbers may differ by `tolerance` relative to the larger one,
/// or by one in their last digit; how long something took may be anything. A line "…" stands for any lines.
std::string difference(const std::vector<std::string>& said, const std::vector<std::string>& printed, double tolerance);

std::vector<std::string> lines_of(const std::string& text);

}  // namespace lacuna
