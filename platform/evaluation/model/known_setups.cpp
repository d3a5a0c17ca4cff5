#include "evaluation/model/known_setups.h"

#include "evaluation/model/possible_values.h"
#include "foundation/address.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

constexpr const char* kNone = "none";

std::string unit_of(const std::string& address, const std::vector<PossibleValue>& values) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const PossibleValue& one) { return one.value.address == address; });
  return found == values.end() ? "1" : found->value.unit;
}

KnownSetup setup_of(const MeasuredFile& file, const ModelDefinition& definition,
                    const std::vector<PossibleValue>& values) {
  KnownSetup setup{.names = {file.setup.name}, .recordings = {file.path.filename().string()}};
  if (file.setup.name.empty()) return setup;
  for (const Setup& one : definition.structure.setups)
    if (one.name == file.setup.name)
      for (const Setup::Value& set : one.values)
        setup.settings.push_back({set.address, set.value, unit_of(set.address, values)});
  std::sort(setup.settings.begin(), setup.settings.end(),
            [](const auto& a, const auto& b) { return a.address < b.address; });
  for (const FreeValue& value : definition.free)
    if (value.setup == file.setup.name) setup.own.emplace_back(without_setup(value.address));
  return setup;
}

/// Two recordings with their own unknown values are never the same setup.
bool is_same(const KnownSetup& a, const KnownSetup& b) {
  return a.settings == b.settings && a.own.empty() && b.own.empty() && a.name().empty() == b.name().empty();
}

}  // namespace

std::vector<KnownSetup> known_setups(const ModelDefinition& definition, const RecordingSource& source) {
  const std::vector<PossibleValue> values = possible_values(definition);
  std::vector<KnownSetup> known;
  for (const MeasuredFile& file : source.files) {
    KnownSetup setup = setup_of(file, definition, values);
    const auto same =
        std::find_if(known.begin(), known.end(), [&](const KnownSetup& one) { return is_same(one, setup); });
    if (same == known.end()) {
      known.push_back(std::move(setup));
      continue;
    }
    if (!setup.name().empty()) same->names.push_back(setup.name());
    same->recordings.push_back(setup.recordings.front());
  }
  if (known.empty()) known.emplace_back();
  return known;
}

bool any_is_set(const std::vector<KnownSetup>& setups) {
  return std::any_of(setups.begin(), setups.end(), [](const KnownSetup& setup) { return !setup.name().empty(); });
}

std::string setup_to_type(const KnownSetup& setup) { return setup.name().empty() ? kNone : setup.name(); }

const KnownSetup& find_setup(const std::vector<KnownSetup>& setups, const std::string& name) {
  std::vector<std::string> names, texts;
  for (const KnownSetup& setup : setups) {
    if (std::find(setup.names.begin(), setup.names.end(), name) != setup.names.end()) return setup;
    names.push_back(setup_to_type(setup));
    names.insert(names.end(), setup.names.begin() + 1, setup.names.end());
    texts.push_back(fmt::format("{} ({})", setup_to_type(setup), settings_text(setup)));
  }
  for (const KnownSetup& setup : setups)  // a recording may be named "none"
    if (name == kNone && setup.name().empty()) return setup;
  if (!any_is_set(setups))
    throw_problem(
        {},
        fmt::format("there is no setup \"{}\": no [[target.recording]] sets a value or has an unknown one of its own",
                    name));
  throw_problem({}, fmt::format("there is no setup \"{}\"{}; the recordings have the setups {}", name,
                                did_you_mean(name, names), fmt::join(texts, "; ")));
}

std::string settings_text(const KnownSetup& setup) {
  if (setup.name().empty()) return "values of the model";
  std::vector<std::string> texts;
  for (const KnownSetup::Setting& set : setup.settings)
    texts.push_back(fmt::format("{} = {:.6g}{}", set.address, set.value, set.unit == "1" ? "" : " " + set.unit));
  for (const std::string& address : setup.own) texts.push_back(address + " fitted to this setup only");
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string setup_text(const KnownSetup& setup) {
  return fmt::format("{} ({})", setup.name().empty() ? "no setup" : "setup " + setup.name(), settings_text(setup));
}

}  // namespace lacuna
