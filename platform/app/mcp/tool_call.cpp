#include "app/mcp/tool_call.h"

#include "foundation/files/allowed_files.h"
#include "foundation/text/json_depth.h"
#include "foundation/text/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

constexpr double kLastGrace = 2.0;                  // s, when the server itself ends
constexpr double kGrace = 10.0;                     // s, for a command that was asked to end
constexpr std::uintmax_t kMostResult = 64U << 20U;  // bytes that are read of results

std::vector<std::string> whole_command(std::vector<std::string> words, const std::filesystem::path& results) {
  words.insert(words.begin(), "/proc/self/exe");  // also where the program's file has been replaced
  if (results.empty()) return words;
  const auto arguments = std::find(words.begin(), words.end(), "--");
  words.insert(arguments, "--json=" + results.string());
  return words;
}

ChildBeginning beginning(const CallPlace& place, std::vector<std::string> words, int output, int errors) {
  const std::string scratch = place.scratch.string();
  return {.words = std::move(words),
          .folder = place.folder,
          .environment = {{kAllowedFolders, place.folder.string() + "\n" + scratch},
                          {"TMPDIR", scratch},
                          {"SQLITE_TMPDIR", scratch}},
          .output = output,
          .errors = errors};
}

/// As `progress_text` writes it: "... · 40 %", then perhaps "· 2 s left".
bool is_progress(const std::string& line) {
  const std::size_t sign = line.find(" %");
  return sign != std::string::npos && sign > 0 && std::isdigit(static_cast<unsigned char>(line[sign - 1])) != 0 &&
         line.find(" · ") < sign && (sign + 2 == line.size() || line.find(" · ", sign) == sign + 2);
}

std::vector<std::string> error_lines(const std::string& text, bool of_progress) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && is_progress(line) == of_progress) lines.push_back(plain_text(line));
  return lines;
}

ordered_json read_results(const std::filesystem::path& file) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(file, missing);
  if (missing) return nullptr;
  if (size > kMostResult) return fmt::format("{} bytes, too many to read; ask for less", size);
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (nests_too_deep(text)) return "is nested too deeply to be read";
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  return json.is_discarded() ? ordered_json("is not JSON") : json;
}

}  // namespace

ToolCall::ToolCall(const CallPlace& place, std::vector<std::string> words, std::filesystem::path results)
    : results_(std::move(results)),
      results_are_ours_(results_.string().starts_with(place.scratch.string())),
      limit_(place.seconds),
      printed_("printed"),
      errors_("errors"),
      child_(beginning(place, whole_command(std::move(words), results_are_ours_ ? results_ : ""), printed_.file(),
                       errors_.file())) {}

ToolCall::~ToolCall() {
  child_.end(kLastGrace);
  std::error_code ignored;
  if (results_are_ours_ && !results_.empty()) std::filesystem::remove(results_, ignored);
}

double ToolCall::seconds() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

void ToolCall::cancel() {
  if (asked_to_end_) return;
  asked_to_end_ = Clock::now();
  child_.ask_to_end();
}

std::optional<CallOutcome> ToolCall::look() {
  if (const std::optional<ChildEnding> ending = child_.ended()) return outcome(*ending);
  if (!asked_to_end_ && seconds() > limit_) {
    was_late_ = true;
    cancel();
  }
  if (asked_to_end_ && std::chrono::duration<double>(Clock::now() - *asked_to_end_).count() > kGrace)
    return outcome(child_.end(0.0));
  return std::nullopt;
}

std::string ToolCall::progress() const {
  const std::vector<std::string> lines = error_lines(errors_.end(), true);
  return lines.empty() ? "" : lines.back();
}

CallOutcome ToolCall::outcome(const ChildEnding& ending) const {
  CallOutcome outcome{ending.code(), nullptr, printed_.end(), error_lines(errors_.end(), false)};
  if (was_late_)
    outcome.notes.push_back(fmt::format("The call reached its limit of {:g} s (lacuna mcp --call-limit).", limit_));
  if (!results_.empty()) outcome.result = read_results(results_);
  return outcome;
}

}  // namespace lacuna
