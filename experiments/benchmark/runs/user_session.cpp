#include "runs/user_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

namespace hidden_effects {
namespace {

constexpr int kBadInput = 2;
constexpr const char* kResult = "result.json";

/// The line that says what went wrong: the last one that is not empty.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  if (end == std::string::npos) return "";
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

/// Throws for whatever is not an exit with 0.
void check(const std::string& command, const ChildOutcome& outcome, double longest) {
  if (outcome.stopped) throw CaseStopped();
  if (outcome.timed_out) throw CaseFailure(fmt::format("lacuna {} took longer than {:g} s", command, longest));
  if (outcome.code > 128)
    throw CaseFailure(fmt::format("lacuna {} crashed with signal {}", command, outcome.code - 128));
  if (outcome.code != 0)
    throw CaseFailure(
        fmt::format("lacuna {} ended with code {}: {}", command, outcome.code, last_line(outcome.errors)));
}

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What `diagnose --among` says cannot be placed in this model.
std::set<std::string> refused(const std::string& errors) {
  static const std::regex kName("--among ([A-Za-z0-9_]+): ");
  std::set<std::string> names;
  for (std::sregex_iterator one(errors.begin(), errors.end(), kName), end; one != end; ++one) names.insert((*one)[1]);
  return names;
}

}  // namespace

UserSession::UserSession(ProgramSettings settings, std::filesystem::path folder, std::vector<std::string> withheld)
    : settings_(std::move(settings)), folder_(std::move(folder)), withheld_(std::move(withheld)) {}

ChildOutcome UserSession::call(std::vector<std::string> words) {
  words.insert(words.begin(), settings_.lacuna.string());
  return run_child(words, folder_, settings_.longest, settings_.stop);
}

std::string UserSession::expect_json(std::vector<std::string> words, ChildOutcome& outcome) {
  const std::string command = words.front();
  words.insert(words.end(), {fmt::format("--json={}", kResult), "--quiet", "--threads", "1", "--db", "case.db"});
  std::filesystem::remove(folder_ / kResult);
  outcome = call(std::move(words));
  if (command != "diagnose" || outcome.code != kBadInput) check(command, outcome, settings_.longest);
  return content(folder_ / kResult);
}

std::vector<std::string> UserSession::library() {
  const ChildOutcome outcome = call({"plugins", "list", fmt::format("--json={}", kResult)});
  check("plugins list", outcome, settings_.longest);
  std::vector<std::string> names = read_effects(content(folder_ / kResult));
  std::erase_if(names, [&](const std::string& name) {
    return std::find(withheld_.begin(), withheld_.end(), name) != withheld_.end();
  });
  return names;
}

DiagnosisRecord UserSession::diagnose() {
  std::vector<std::string> among = withheld_.empty() ? std::vector<std::string>() : library();
  ChildOutcome outcome;
  std::string json;
  // What this robot or model has no place for is known when the program has refused it.
  for (bool again = true; again;) {
    std::vector<std::string> words = {"diagnose", "rig.toml"};
    if (!among.empty()) words.emplace_back("--among");
    words.insert(words.end(), among.begin(), among.end());
    json = expect_json(std::move(words), outcome);
    const std::set<std::string> without = outcome.code == kBadInput ? refused(outcome.errors) : std::set<std::string>();
    again = std::erase_if(among, [&](const std::string& name) { return without.contains(name); }) > 0 && !among.empty();
  }
  return read(json, outcome);
}

DiagnosisRecord UserSession::diagnose_among(const std::vector<std::string>& effects) {
  std::vector<std::string> words = {"diagnose", "rig.toml", "--among"};
  words.insert(words.end(), effects.begin(), effects.end());
  ChildOutcome outcome;
  const std::string json = expect_json(std::move(words), outcome);
  return read(json, outcome);
}

DiagnosisRecord UserSession::read(const std::string& json, const ChildOutcome& outcome) const {
  check("diagnose", outcome, settings_.longest);
  DiagnosisRecord record = read_diagnosis(json);
  record.processor_seconds = outcome.processor_seconds;
  return record;
}

void UserSession::write_commands(const std::string& test, const std::string& file) {
  ChildOutcome outcome;
  expect_json({"trial", "rig.toml", "--test", test, "--csv=" + file}, outcome);
}

void UserSession::add(const EffectAt& what) {
  std::vector<std::string> words = {"add", "rig.toml", what.effect};
  if (what.place != "world") words.insert(words.end(), {"--where", what.place});
  ChildOutcome outcome;
  expect_json(std::move(words), outcome);
}

ReadComparison UserSession::compare() {
  ChildOutcome outcome;
  return read_comparison(expect_json({"compare", "rig.toml"}, outcome));
}

std::string program_version(const ProgramSettings& settings, const std::filesystem::path& folder) {
  const ChildOutcome outcome =
      run_child({settings.lacuna.string(), "--version"}, folder, settings.longest, settings.stop);
  check("--version", outcome, settings.longest);
  return last_line(outcome.output);
}

}  // namespace hidden_effects
