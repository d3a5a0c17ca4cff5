#include "formula/force_law.h"

#include "formula/formula_checks.h"
#include "formula/formula_parser.h"
#include "formula/formula_scanner.h"
#include "formula/formula_unit.h"
#include "formula/law_terms.h"
#include "foundation/placement_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

namespace lacuna {
namespace {

using Kind = Expression::Kind;

constexpr double kReach = 100.0;  ///< largest magnitude of a parameter, times its start

/// A bound, without rounding digits after the third.
double rounded(double bound) { return std::strtod(fmt::format("{:.3g}", bound).c_str(), nullptr); }

/// Whether a fit can start there and has bounds around it.
bool can_start(double number) { return number != 0.0 && std::isfinite(rounded(kReach * number)); }

/// A formula on one line: it is written into comments and strings.
std::string on_one_line(std::string formula) {
  std::replace_if(
      formula.begin(), formula.end(), [](unsigned char c) { return std::isspace(c) != 0; }, ' ');
  return formula;
}

/// Roles of names in a formula: `factor` multiplies a whole term, `summand` shifts something inside a term, `scale`
/// divides or scales something and must keep its sign.
enum class Role { factor, summand, scale };

class Roles {
 public:
  explicit Roles(const std::vector<RawTerm>& terms) {
    for (const RawTerm& term : terms) {
      for (const Expression& factor : term.over)
        factor.kind == Kind::parameter ? note(factor, Role::factor) : look_into(factor);
      for (const Expression& divisor : term.under)
        divisor.kind == Kind::parameter ? note(divisor, Role::scale) : look_into(divisor);
    }
  }

  const std::map<std::string, Role>& all() const { return roles_; }
  int column(const std::string& name) const { return columns_.at(name); }
  std::set<std::string> scales() const {
    std::set<std::string> names;
    for (const auto& [name, role] : roles_)
      if (role == Role::scale) names.insert(name);
    return names;
  }

 private:
  void note(const Expression& name, Role role) {
    columns_.emplace(name.name, name.column);
    Role& known = roles_.emplace(name.name, role).first->second;
    known = std::max(known, role);
  }
  void look_into(const Expression& expression) {
    walk(expression, [&](const Expression& e) {
      const bool sum = e.kind == Kind::sum || e.kind == Kind::difference;
      for (const Expression& part : e.parts)
        if (part.kind == Kind::parameter) note(part, sum ? Role::summand : Role::scale);
    });
  }

  std::map<std::string, Role> roles_;
  std::map<std::string, int> columns_;
};

void check_values(const Roles& roles, const std::map<std::string, double>& values, ProblemList& problems) {
  constexpr const char* kWhy = "the fit starts there and its bounds follow from it";
  for (const auto& [name, role] : roles.all()) {
    const SourceLocation place = formula_place(roles.column(name));
    const auto found = values.find(name);
    if (found == values.end())
      problems.add(place, fmt::format("the parameter {0} has no value; add --value {0}=NUMBER; {1}", name, kWhy));
    else if (!can_start(found->second))
      problems.add(place, fmt::format("the value of {} must be a number other than 0; {}", name, kWhy));
    else if (role == Role::scale && found->second < 0.0)
      problems.add(place,
                   fmt::format("{} divides or scales something and must be positive; give it a positive value", name));
  }
  std::vector<std::string> names;
  for (const auto& [name, role] : roles.all()) names.push_back(name);
  for (const auto& [name, value] : values)
    if (!roles.all().contains(name))
      problems.add({"--value", 0, 0}, name + " is no parameter of the formula" + did_you_mean(name, names));
}

void check_terms(const std::vector<RawTerm>& terms, ProblemList& problems) {
  std::map<std::string, int> seen;
  for (const RawTerm& term : terms) {
    const std::string text = formula_text(term.rest());
    if (!can_start(term.number))
      problems.add(formula_place(term.column),
                   "the coefficient of the term " + text +
                       " must be finite and not 0: the fit starts there and its bounds follow from it");
    if (!seen.emplace(text, term.column).second)
      problems.add(formula_place(term.column), "there are two terms with " + text + "; write one");
  }
}

/// Turns terms into parameters and values.
class LawBuilder {
 public:
  LawBuilder(const std::vector<RawTerm>& terms, const Roles& roles, const std::map<std::string, double>& values,
             ProblemList& problems)
      : terms_(terms), roles_(roles), values_(values), problems_(problems) {
    for (const auto& [name, role] : roles.all()) taken_.insert(name);
    for (const RawTerm& term : terms) note_inner_units(term.rest());
  }

  void build(ForceLaw& law) {
    for (std::size_t i = 0; i < terms_.size(); ++i) add_term(terms_[i], i + 1, law);
    for (const RawTerm& term : terms_) add_inner(term.rest(), law);
  }

 private:
  bool heads(const Expression& factor) const {
    return factor.kind == Kind::parameter && roles_.all().at(factor.name) == Role::factor;
  }
  static bool declared(const ForceLaw& law, const std::string& name) {
    return std::any_of(law.parameters.begin(), law.parameters.end(),
                       [&](const LawParameter& parameter) { return parameter.name == name; });
  }
  static LawParameter multiplier(const std::string& name, double start, const Expression& of) {
    const double reach = rounded(kReach * std::abs(start));
    return {{.name = name,
             .unit = unit_of_factor(dimension_of(of)),
             .default_value = start,
             .lower = -reach,
             .upper = reach,
             .description = of.is_number() ? "A constant force" : "Coefficient of " + formula_text(of)}};
  }

  void add_term(const RawTerm& raw, std::size_t count, ForceLaw& law) {
    RawTerm left = raw;  // the part that the number multiplies
    const auto head = std::find_if(left.over.begin(), left.over.end(), [&](const Expression& f) { return heads(f); });
    Expression factor{Kind::parameter, 0.0, {}, {}, raw.column};
    double number = 1.0;
    if (head != left.over.end()) {
      factor.name = head->name;
      number = raw.number;
      left.over.erase(head);
      note_unit(factor.name, unit_of_factor(dimension_of(left.rest())));
      if (!declared(law, factor.name))
        law.parameters.push_back(multiplier(factor.name, values_.at(factor.name), left.rest()));
      if (std::abs(number) != 1.0)
        law.notes.push_back(fmt::format("{} is constant in the term with {}; a fit changes {} alone",
                                        number_text(number), factor.name, factor.name));
    } else {
      factor.name = free_name(left.rest(), count);
      law.parameters.push_back(multiplier(factor.name, raw.number, left.rest()));
    }
    law.terms.push_back(term_of(std::move(factor), number, std::move(left)));
  }

  static LawTerm term_of(Expression factor, double number, RawTerm left) {
    const auto is_direction = [](const Expression& e) { return e.is_call_of("sgn", "v"); };
    const bool along = std::count_if(left.over.begin(), left.over.end(), is_direction) == 1;
    if (along) left.over.erase(std::find_if(left.over.begin(), left.over.end(), is_direction));
    left.over.insert(left.over.begin(), std::move(factor));
    if (std::abs(number) != 1.0)
      left.over.insert(left.over.begin(), Expression{Kind::number, number, {}, {}, left.column});
    else if (number < 0.0)
      left.over.front() = Expression{Kind::negation, 0.0, {}, {left.over.front()}, left.column};
    Expression value = left.over.front();
    for (std::size_t i = 1; i < left.over.size(); ++i)
      value = Expression{Kind::product, 0.0, {}, {value, left.over[i]}, left.column};
    for (const Expression& divisor : left.under)
      value = Expression{Kind::quotient, 0.0, {}, {value, divisor}, left.column};
    return {std::move(value), along};
  }

  /// Complains of a name with two units.
  void note_unit(const std::string& name, const std::string& unit) {
    const std::string& known = units_.emplace(name, unit).first->second;
    if (known != unit)
      problems_.add(
          formula_place(roles_.column(name)),
          fmt::format("{0} has the unit {1} in one place and {2} in another; use two names, as in {0} and {0}_2", name,
                      unit_in_words(known), unit_in_words(unit)));
  }

  /// Beside a number, which has any unit that fits, the unit of a name is undetermined.
  void note_inner_units(const Expression& rest) {
    for (const auto& [name, dimension] : inner_dimensions(rest))
      if (dimension != FormulaDimension{}) note_unit(name, unit_of(dimension));
  }

  /// Names inside terms.
  void add_inner(const Expression& rest, ForceLaw& law) {
    walk(rest, [&](const Expression& e) {
      if (e.kind != Kind::parameter || declared(law, e.name)) return;
      const double start = values_.at(e.name), reach = rounded(kReach * std::abs(start));
      LawParameter parameter{{.name = e.name,
                              .unit = units_.emplace(e.name, "1").first->second,
                              .default_value = start,
                              .lower = -reach,
                              .upper = reach,
                              .description = "A scale inside " + formula_text(rest)},
                             start};
      if (roles_.all().at(e.name) == Role::scale) {
        parameter.lower = rounded(start / kReach);
        parameter.scale = Scale::logarithmic;  // it keeps its sign
      } else if (roles_.all().at(e.name) == Role::summand) {
        parameter.description = "A shift inside " + formula_text(rest);
      } else {  // the second of two names that multiply a term
        parameter.description = "A further factor of " + formula_text(rest);
      }
      law.parameters.push_back(std::move(parameter));
    });
  }

  std::string free_name(const Expression& rest, std::size_t count) {
    std::string name = name_of_factor(rest);
    if (name.empty() || taken_.contains(name)) name = "term_" + std::to_string(count);
    while (taken_.contains(name)) name += "_";
    taken_.insert(name);
    return name;
  }

  const std::vector<RawTerm>& terms_;
  const Roles& roles_;
  const std::map<std::string, double>& values_;
  ProblemList& problems_;
  std::set<std::string> taken_;
  std::map<std::string, std::string> units_;
};

}  // namespace

std::string ForceLaw::equation() const {
  std::string sum;
  for (const LawTerm& term : terms) {
    const std::string value = formula_text(term.value) + (term.along_motion ? "*sgn(v)" : "");
    if (sum.empty())
      sum = value;
    else
      sum += value.front() == '-' ? " - " + value.substr(1) : " + " + value;
  }
  return sum;
}

ForceLaw read_force_law(const std::string& formula, const std::map<std::string, double>& values) {
  ProblemList problems;
  const std::optional<Expression> parsed = parse_formula(formula, problems);
  problems.throw_if_any();
  const std::vector<RawTerm> terms = terms_of(*parsed);
  const Roles roles(terms);
  check_terms(terms, problems);
  check_values(roles, values, problems);
  check_finite(*parsed, roles.scales(), problems);
  problems.throw_if_any();
  ForceLaw law;
  law.text = on_one_line(formula);
  walk(*parsed, [&](const Expression& e) {
    law.uses_command = law.uses_command || (e.kind == Kind::variable && e.name == "u");
  });
  LawBuilder(terms, roles, values, problems).build(law);
  problems.throw_if_any();
  return law;
}

}  // namespace lacuna
