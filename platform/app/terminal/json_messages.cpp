#include "app/terminal/json_messages.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <string_view>

namespace lacuna {
namespace {

using MessageJson = nlohmann::ordered_json;

/// A file name need not be UTF-8; what is not becomes the replacement character.
std::string on_a_line(const MessageJson& message) {
  return message.dump(-1, ' ', false, MessageJson::error_handler_t::replace) + "\n";
}

}  // namespace

bool messages_are_json() {
  const char* const wanted = std::getenv("LACUNA_MESSAGES");
  if (wanted == nullptr || *wanted == '\0' || std::string_view(wanted) == "text") return false;
  if (std::string_view(wanted) == "json") return true;
  throw_problem({}, "environment variable LACUNA_MESSAGES: \"" + std::string(wanted) +
                        "\" is not a message format; set it to json or text, or unset it");
}

std::string progress_message(const Progress& progress) {
  return on_a_line({{"progress",
                     {{"phase", progress.what},
                      {"fraction", progress.fraction},
                      {"seconds_left", progress.seconds_left}}}});  // not known: null
}

std::string problem_messages(const BadInput& bad) {
  std::string lines;
  for (const Problem& problem : bad.problems())
    lines += on_a_line({{"problem",
                         {{"file", problem.location.file},
                          {"line", problem.location.line},
                          {"column", problem.location.column},
                          {"key", problem.key},
                          {"message", problem.message}}}});
  return lines;
}

std::string failure_message(const std::string& sentence) { return on_a_line({{"failure", sentence}}); }

}  // namespace lacuna
