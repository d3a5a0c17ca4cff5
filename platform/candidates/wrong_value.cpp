#include "candidates/wrong_value.h"

#include "foundation/address.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kTimes = 10.0;  ///< times more or less, for a value that is never negative
constexpr double kAway = 3.0;    ///< times its size, for a value that may change its sign
constexpr std::array kTried = {"body.", "joint.", "actuator.", "sensor.", "coupling."};
constexpr std::array kNotTried = {".noise", ".quantum"};

bool states_something(const AddressedValue& value) {
  const double number = *value.value;
  return std::isfinite(number) && number != 0.0 && !(number == 1.0 && value.unit == "1");
}

bool may_be_tried(const std::string& address) {
  const auto begins = [&](const char* kind) { return address.starts_with(kind); };
  const auto ends = [&](const char* name) { return address.ends_with(name); };
  return std::any_of(kTried.begin(), kTried.end(), begins) && std::none_of(kNotTried.begin(), kNotTried.end(), ends);
}

/// Whether some recording sets this value.
bool is_of_setups(const ModelDefinition& base, const std::string& address) {
  const std::vector<Setup>& setups = base.structure.setups;
  return std::any_of(setups.begin(), setups.end(), [&](const Setup& setup) {
    return std::any_of(setup.values.begin(), setup.values.end(),
                       [&](const auto& value) { return matches(value.address, address); });
  });
}

std::pair<double, double> range_of(const AddressedValue& value) {
  const double number = *value.value;
  if (value.lower == 0.0) return {0.0, std::min(value.upper, number * kTimes)};
  if (value.lower > 0.0) return {std::max(value.lower, number / kTimes), std::min(value.upper, number * kTimes)};
  const double away = kAway * std::abs(number);
  return {std::max(value.lower, number - away), std::min(value.upper, number + away)};
}

}  // namespace

bool is_wrong_value(const EffectEntry& entry) { return entry.effect == kWrongValue; }

std::vector<EffectEntry> wrong_values(const ModelDefinition& base) {
  std::vector<EffectEntry> entries;
  RobotSpec robot = base.structure.robot;
  for (const AddressedValue& value : addressed_values(robot)) {
    const bool is_free = std::any_of(base.free.begin(), base.free.end(), [&](const FreeValue& free) {
      return without_setup(free.address) == value.address;
    });
    if (is_free || is_of_setups(base, value.address) || !states_something(value) || !may_be_tried(value.address))
      continue;
    EffectEntry entry;
    entry.id = value.address;
    entry.effect = kWrongValue;
    entry.where = {value.address};
    entry.range = {{last_name(value.address), range_of(value)}};
    entries.push_back(std::move(entry));
  }
  return entries;
}

FreeRange free_range(const EffectEntry& entry) {
  const std::string& address = entry.where.front();
  const std::string name = last_name(address);
  const auto& [lower, upper] = entry.range.at(name);
  const auto start = entry.start.find(name);
  return {address, lower, upper, start == entry.start.end() ? std::nullopt : std::optional(start->second)};
}

Experiment with_free_value(Experiment experiment, const EffectEntry& entry) {
  experiment.model.free.push_back(free_range(entry));
  return experiment;
}

bool belongs_to(const FreeValue& free, const EffectEntry& entry) {
  return is_wrong_value(entry) ? free.address == entry.where.front() : is_of_effect(free.address, entry.id);
}

std::string last_name(const std::string& address) { return address.substr(address.rfind('.') + 1); }

}  // namespace lacuna
