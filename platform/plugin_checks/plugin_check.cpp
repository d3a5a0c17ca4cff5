#include "plugin_checks/plugin_check.h"

#include "foundation/plugins/plugin_call.h"
#include "loading/child_process.h"
#include "loading/component_kinds.h"
#include "loading/plugin_library.h"
#include "plugin_checks/component_check.h"
#include "plugin_checks/failures.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <span>

namespace lacuna {
namespace {

constexpr unsigned kSecondsOfACheck = 10;
constexpr const char* kHandshake = "handshake";

std::span<const ComponentEntry> components_of(const PluginLibrary& library) {
  return {library.table().components, library.table().component_count};
}

ComponentOrigin origin_of(const ComponentEntry& entry, const PluginLibrary& library) {
  ComponentOrigin origin = {component_noun(entry.kind), entry.name, library.file()};
  origin.on_page = on_page(origin);
  return origin;
}

std::string key_of(const ComponentEntry& entry) { return component_noun(entry.kind) + " " + entry.name; }

CheckResult sound_handshake(const PluginTable& table) {
  return {kHandshake,
          CheckOutcome::passed,
          fmt::format("interface {}, {}, {}, build {}", table.interface_version, table.compiler, table.standard_library,
                      table.build_id == nullptr ? "unknown" : table.build_id),
          {},
          {}};
}

CheckResult failed_handshake(const std::filesystem::path& file, std::string sentence) {
  const std::string prefix = file.string() + ": ";
  if (sentence.starts_with(prefix)) sentence.erase(0, prefix.size());
  return {kHandshake, CheckOutcome::failed, sentence, "The program refuses the library with all of its components.",
          "Build it with this program's headers and compiler, or correct the fault, and check again."};
}

std::string packed(const CheckResult& result) {
  return json_of(result).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The result of a child process, or how it ended.
CheckResult unpacked(const std::string& check, const ChildAnswer& answer) {
  if (answer.death.empty()) return check_result_of(answer.answer);
  return failed(check, kEndedReason, (answer.call.empty() ? "its code" : answer.call) + " " + answer.death);
}

/// Carries out the checks of one component, each in a separate child process.
class ComponentSeries {
 public:
  ComponentSeries(const ComponentEntry& entry, const PluginLibrary& library, const ExerciseInputs& inputs)
      : entry_(entry), origin_(origin_of(entry, library)), inputs_(inputs) {}

  ComponentChecks run() {
    ComponentChecks checks = {origin_.kind, origin_.name, {}};
    std::string ended_by;
    for (const std::string& check : component_check_names()) {
      if (!ended_by.empty()) {
        checks.checks.push_back({check, CheckOutcome::not_applicable, "not carried out after " + ended_by, {}, {}});
        continue;
      }
      const std::vector<ChildAnswer> answers = ask_in_child(
          1, [&](std::size_t) { return packed(check_component(entry_, origin_, check, inputs_)); }, kSecondsOfACheck);
      checks.checks.push_back(unpacked(check, answers.front()));
      if (!answers.front().death.empty()) ended_by = check;
    }
    return checks;
  }

  /// In a separate child process; nothing where it has no numbers.
  std::optional<std::string> digest() {
    const std::vector<ChildAnswer> answers = ask_in_child(
        1, [&](std::size_t) { return transcript_digest(entry_, origin_, inputs_); }, kSecondsOfACheck);
    if (!answers.front().death.empty() || answers.front().answer.empty()) return std::nullopt;
    return answers.front().answer;
  }

 private:
  const ComponentEntry& entry_;
  ComponentOrigin origin_;
  const ExerciseInputs& inputs_;
};

CheckResult* find_check(ComponentChecks& checks, const std::string& name) {
  for (CheckResult& result : checks.checks)
    if (result.check == name) return &result;
  return nullptr;
}

/// Whether it gave the same numbers twice.
bool is_steady(ComponentChecks& checks) {
  const CheckResult* result = find_check(checks, "determinism");
  return result != nullptr && result->outcome == CheckOutcome::passed;
}

/// Adds the numbers of another process to the check of determinism, which the component has passed.
void compare_processes(ComponentChecks& checks, const std::optional<std::string>& here, const std::string& there) {
  CheckResult* result = find_check(checks, "determinism");
  if (!here) return;
  if (there == *here)
    result->finding += ", and in another process";
  else if (checks.kind != ComponentKind<TargetSystem>::noun)
    *result = failed_check("determinism", there.empty() ? "another process received no numbers from it"
                                                        : "another process receives other numbers from it");
}

void refuse_duplicates(std::vector<ComponentChecks>& components) {
  std::set<std::pair<std::string, std::string>> seen;
  for (ComponentChecks& component : components)
    if (!seen.insert({component.kind, component.name}).second)
      component.checks.front() = failed_check(
          "declarations", "two components of the library are the " + component.kind + " " + component.name);
}

}  // namespace

PluginChecks check_plugin(const std::filesystem::path& file, const ExerciseInputs& inputs,
                          const OtherProcess& other_process) {
  PluginChecks checks = {file.string(), {}, {}};
  std::optional<PluginLibrary> library;
  try {
    library = PluginLibrary::load(file);
  } catch (const Error& error) {
    checks.handshake = failed_handshake(file, error.what());
    return checks;
  }
  checks.handshake = sound_handshake(library->table());
  CallPage::watch_exits();
  std::optional<TranscriptDigests> there;
  for (const ComponentEntry& entry : components_of(*library)) {
    ComponentSeries series(entry, *library, inputs);
    checks.components.push_back(series.run());
    if (!is_steady(checks.components.back())) continue;
    if (!there) there = other_process();
    const auto found = there->find(key_of(entry));
    compare_processes(checks.components.back(), series.digest(), found == there->end() ? "" : found->second);
  }
  refuse_duplicates(checks.components);
  return checks;
}

TranscriptDigests transcript_digests(const std::filesystem::path& file, const ExerciseInputs& inputs) {
  const PluginLibrary library = PluginLibrary::load(file);
  TranscriptDigests digests;
  for (const ComponentEntry& entry : components_of(library))
    if (const std::optional<std::string> digest = ComponentSeries(entry, library, inputs).digest())
      digests[key_of(entry)] = *digest;
  return digests;
}

}  // namespace lacuna
