// Any text is a force law, whose equation is one again, or is refused with located problems.
// What follows a line break are the names of parameters that get a value.

#include "formula/effect_source.h"
#include "formula/formula_parser.h"
#include "fuzzing.h"

#include <sstream>

namespace {

using lacuna::fuzz::require;

std::map<std::string, double> values_of(const std::string& names) {
  std::map<std::string, double> values;
  std::istringstream words(names);
  for (std::string name; words >> name;) values.emplace(name, 0.25 * static_cast<double>(values.size() + 1));
  return values;
}

/// What is written is read as what was written.
void require_same(const std::string& formula) {
  lacuna::ProblemList problems;
  const auto read = lacuna::parse_formula(formula, problems);
  if (!read) return;
  const std::string text = lacuna::formula_text(*read);
  const auto again = lacuna::parse_formula(text, problems);
  if (text.size() <= formula.size()) require(again.has_value(), "a formula that is written is read");
  if (again) require(lacuna::formula_text(*again) == text, "a formula that is read again is the same");
}

void write_plugin(const lacuna::ForceLaw& law) {
  require(!law.terms.empty(), "a law has terms");
  for (const lacuna::LawParameter& parameter : law.parameters)
    require(parameter.lower < parameter.upper, "bounds are in order");
  require(!law.equation().empty(), "a law has an equation");
  require(lacuna::effect_source("fuzzed", law).find('@') == std::string::npos, "a source has no marks");
  lacuna::effect_readme("fuzzed", law);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = lacuna::fuzz::text_of(data, size);
  const std::size_t end = text.find('\n');
  const std::string formula = text.substr(0, end);
  const auto values = values_of(end == std::string::npos ? "a b c w" : text.substr(end + 1));
  require_same(formula);
  try {
    write_plugin(lacuna::read_force_law(formula, values));
  } catch (const lacuna::BadInput& bad) {
    require(!bad.problems().empty(), "bad input has a problem");
  }
  return 0;
}
