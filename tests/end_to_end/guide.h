#pragma once

#include "end_to_end/program.h"

#include <string>
#include <vector>

namespace lacuna {

/// Of a figure in a document: compilers and processors differ in last digits.
inline constexpr double kFigureTolerance = 0.05;

/// A step of a guide in Markdown, which a reader would take by hand.
struct GuideStep {
  int line = 0;                    ///< in the document, from 1
  std::string command;             ///< as a shell takes it; empty: an edit
  std::string file;                ///< of an edit
  std::vector<std::string> lines;  ///< what the command is said to print, or lines that the edit puts into the file
  int exit_code = 0;               ///< that the command is said to end with: a last line "(exit code 2)"
};

/// The steps of all ```console blocks ("$ " begins a command, its output follows) and of all ```toml blocks
/// that name a file behind the language (each line "KEY = VALUE" takes the place of the file's line with that key).
std::vector<GuideStep> guide_steps(const std::string& markdown);

/// Takes the steps of a document of the source tree, such as "docs/tutorials/first-steps.md", in the program's folder.
/// A command that does not print what is said, or ends with another exit code, fails the test. `until`: the heading
/// before which to stop; empty: the end.
void follow_guide(const std::string& document, const Program& program, const std::string& until = "");

/// The words of a picture, one a line.
std::vector<std::string> words_of_picture(const std::string& svg);

/// `text` after an edit: each line takes the place of the first one that sets the same key, be it commented out or
/// not. A key that is not there but follows one that is goes below it. Throws where the first key is nowhere.
std::string edited(const std::string& text, const std::vector<std::string>& lines);

/// The content of a file of the source tree, as in "docs/tutorials/first-steps.md".
std::string source_file(const std::string& name);

}  // namespace lacuna
