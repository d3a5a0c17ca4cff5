#include "runs/selection.h"

#include "contacts/contact_plan.h"
#include "dirty/dirty_plan.h"
#include "runs/dirty_truth.h"

#include <charconv>
#include <stdexcept>
#include <utility>

namespace hidden_effects {
namespace {

int whole_number(const std::string& text, const std::string& whole, const char* option, const char* form) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end)
    throw std::invalid_argument(std::string(option) + " " + whole + ": write it as " + form);
  return number;
}

std::pair<int, int> two_numbers(const std::string& text, char between, const char* option, const char* form) {
  const std::size_t at = text.find(between);
  const int first = whole_number(text.substr(0, at), text, option, form);
  return {first, at == std::string::npos ? first : whole_number(text.substr(at + 1), text, option, form)};
}

}  // namespace

std::vector<CasePlan> plans_of_set(const std::string& set) {
  return dirty::is_dirty_set(set) ? dirty_case_plans(set) : plan_all_cases(set);
}

std::vector<CasePlan> selected(std::vector<CasePlan> plans, const std::string& cases, const std::string& part) {
  const std::size_t all = plans.size();
  if (!cases.empty()) {
    const auto [first, last] = two_numbers(cases, '-', "--cases", "A-B, as in 0-39");
    if (last < first) throw std::invalid_argument("--cases " + cases + ": write the smaller number first");
    if (last >= static_cast<int>(all))
      throw std::invalid_argument("--cases " + cases + ": the set's numbers go from 0 to " + std::to_string(all - 1));
    std::erase_if(
        plans, [first = first, last = last](const CasePlan& one) { return one.number < first || one.number > last; });
  }
  if (part.empty()) return plans;
  const auto [k, n] = two_numbers(part, '/', "--part", "K/N, as in 2/8");
  if (part.find('/') == std::string::npos || k < 1 || k > n)
    throw std::invalid_argument("--part " + part + ": write it as K/N, as in 2/8, with K from 1 to N");
  std::vector<CasePlan> mine;
  for (std::size_t i = static_cast<std::size_t>(k) - 1; i < plans.size(); i += static_cast<std::size_t>(n))
    mine.push_back(plans[i]);
  return mine;
}

}  // namespace hidden_effects
