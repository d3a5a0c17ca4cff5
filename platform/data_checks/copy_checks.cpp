#include "data_checks/copy_checks.h"

#include "storage/core/canonical_text.h"

#include <fmt/format.h>

#include <map>

namespace lacuna {
namespace {

DataWarning copy_doubt(const Trial& copy, const Trial& of) {
  const std::string what = fmt::format("{} holds the same samples as {}", copy.name, of.name);
  if (copy.held_out != of.held_out)
    return {Severity::note,
            what + ", and one of them is held out: a copy confirms nothing; hold another recording out"};
  return {Severity::note, what + ": data that count twice make every result look surer than it is; leave one out"};
}

}  // namespace

std::vector<DataWarning> copy_checks(const std::vector<Trial>& trials) {
  std::vector<DataWarning> doubts;
  std::map<std::string, const Trial*> seen;
  for (const Trial& trial : trials) {
    const auto [first, is_new] = seen.try_emplace(digest_of(trial), &trial);
    if (!is_new) doubts.push_back(copy_doubt(trial, *first->second));
  }
  return doubts;
}

}  // namespace lacuna
