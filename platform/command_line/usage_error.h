#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace lacuna {

/// What is wrong with a command line, in one sentence that begins with the command and ends with where
/// help is: an unknown command or option with the nearest name, an argument too many, one that is missing.
std::string usage_sentence(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv);

}  // namespace lacuna
