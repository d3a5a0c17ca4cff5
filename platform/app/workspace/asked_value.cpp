#include "app/workspace/asked_value.h"

#include "app/terminal/short_number.h"
#include "candidates/wrong_value.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

/// Why an address is no fixed value of the robot.
std::string objection(const std::string& wanted, const std::vector<std::string>& addresses,
                      const ModelDefinition& base) {
  if (wanted.empty()) return "";
  for (const FreeValue& free : base.free)
    if (free.address == wanted) return "; " + wanted + " is fitted already";
  return "; there is no value " + wanted + did_you_mean(wanted, addresses);
}

void check_start(const std::map<std::string, double>& start, const std::string& name,
                 const std::pair<double, double>& range) {
  for (const auto& [key, value] : start) {
    if (key != name)
      throw_problem(
          {}, fmt::format("add wrong_value: --start {}: the value is {}; write --start {}=NUMBER", key, name, name));
    if (value < range.first || value > range.second)
      throw_problem(
          {},
          fmt::format("add wrong_value: --start {}={}: is outside the search range; choose a start between {} and {}",
                      key, value, range.first, range.second));
  }
}

}  // namespace

EffectEntry asked_value(const std::vector<std::string>& where, const std::string& id,
                        const std::vector<std::string>& fixed, const std::map<std::string, double>& start,
                        const ModelDefinition& base) {
  if (!id.empty() || !fixed.empty())
    throw_problem({}, "add wrong_value: a freed value has no id and is always fitted; leave out --id and --fixed");
  const std::vector<EffectEntry> entries = wrong_values(base);
  std::vector<std::string> addresses;
  for (const EffectEntry& entry : entries) addresses.push_back(entry.where.front());
  const std::string wanted = where.size() == 1 ? where.front() : "";
  const auto found = std::find(addresses.begin(), addresses.end(), wanted);
  if (found == addresses.end())
    throw_problem({}, "add wrong_value: name one fixed value that the robot file states, such as --where " +
                          (addresses.empty() ? "joint.hinge.armature" : addresses.front()) +
                          objection(wanted, addresses, base));
  EffectEntry entry = entries[static_cast<std::size_t>(found - addresses.begin())];
  for (auto& [name, range] : entry.range) range = {short_number(range.first), short_number(range.second)};
  check_start(start, entry.range.begin()->first, entry.range.begin()->second);
  entry.start = start;
  return entry;
}

}  // namespace lacuna
