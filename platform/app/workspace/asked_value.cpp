#include "app/workspace/asked_value.h"

#include "app/terminal/short_number.h"
#include "candidates/wrong_value.h"
#include "foundation/problem.h"

#include <algorithm>

namespace lacuna {

EffectEntry asked_value(const std::vector<std::string>& where, const std::string& id,
                        const std::vector<std::string>& fixed, const ModelDefinition& base) {
  if (!id.empty() || !fixed.empty())
    throw_problem({},
                  "add wrong_value: a value of the robot has its own name and is fitted; leave out --id and --fixed");
  const std::vector<EffectEntry> entries = wrong_values(base);
  std::vector<std::string> addresses;
  for (const EffectEntry& entry : entries) addresses.push_back(entry.where.front());
  const std::string wanted = where.size() == 1 ? where.front() : "";
  const auto found = std::find(addresses.begin(), addresses.end(), wanted);
  if (found == addresses.end())
    throw_problem({}, "add wrong_value: name one fixed value that the robot file states, such as --where " +
                          (addresses.empty() ? "joint.hinge.armature" : addresses.front()) +
                          (wanted.empty() ? "" : "; " + wanted + " is none" + did_you_mean(wanted, addresses)));
  EffectEntry entry = entries[static_cast<std::size_t>(found - addresses.begin())];
  for (auto& [name, range] : entry.range) range = {short_number(range.first), short_number(range.second)};
  return entry;
}

}  // namespace lacuna
