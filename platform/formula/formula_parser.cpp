#include "formula/formula_parser.h"

#include "formula/formula_scanner.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

namespace lacuna {
namespace {

using Kind = Expression::Kind;

constexpr std::size_t kLongest = 2000;  ///< characters
constexpr int kDeepest = 40;            ///< parentheses in parentheses

double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

const std::map<std::string, double (*)(double)>& functions() {
  static const std::map<std::string, double (*)(double)> all = {
      {"abs", [](double x) { return std::abs(x); }},   {"sgn", sign},
      {"sin", [](double x) { return std::sin(x); }},   {"cos", [](double x) { return std::cos(x); }},
      {"exp", [](double x) { return std::exp(x); }},   {"tanh", [](double x) { return std::tanh(x); }},
      {"sqrt", [](double x) { return std::sqrt(x); }},
  };
  return all;
}

constexpr const char* kFunctionNames = "abs, sgn, sin, cos, exp, tanh and sqrt";

/// The value of an expression of numbers.
double value_of(const Expression& e) {
  const auto part = [&](std::size_t i) { return e.parts[i].number; };
  switch (e.kind) {
    case Kind::negation: return -part(0);
    case Kind::sum: return part(0) + part(1);
    case Kind::difference: return part(0) - part(1);
    case Kind::product: return part(0) * part(1);
    case Kind::quotient: return part(0) / part(1);
    case Kind::power: return std::pow(part(0), part(1));
    case Kind::call: return functions().at(e.name)(part(0));
    case Kind::number:
    case Kind::variable:
    case Kind::parameter: break;
  }
  return e.number;
}

/// Thrown at a fault of the structure, after it was reported.
struct Fault {};

/// sum := product (('+' | '-') product)*       product := unary (('*' | '/') unary)*
/// unary := ('-' | '+') unary | power          power := primary ('^' unary)?
/// primary := number | name | function '(' sum ')' | '(' sum ')'
class Parser {
 public:
  Parser(std::vector<FormulaToken> tokens, ProblemList& problems) : tokens_(std::move(tokens)), problems_(problems) {}

  Expression parse() {
    if (now().kind == FormulaToken::Kind::end) fail("the formula is empty; write a force law such as -0.01*v*abs(v)");
    Expression all = sum();
    if (is(")")) fail("this ) has no matching (; remove it or add a ( before it");
    if (now().kind != FormulaToken::Kind::end)
      fail("an operator is missing before \"" + now().text + "\"; write products with *");
    return all;
  }

 private:
  const FormulaToken& now() const { return tokens_[at_]; }
  bool is(const char* sign) const { return now().kind == FormulaToken::Kind::sign && now().text == sign; }
  FormulaToken take() { return tokens_[at_++]; }
  void complain(int column, std::string sentence) { problems_.add(formula_place(column), std::move(sentence)); }
  [[noreturn]] void fail(std::string sentence) {
    complain(now().column, std::move(sentence));
    throw Fault{};
  }

  Expression made(Kind kind, int column, std::vector<Expression> parts, std::string name = {}) {
    Expression e{kind, 0.0, std::move(name), std::move(parts), column};
    if (!std::all_of(e.parts.begin(), e.parts.end(), [](const Expression& part) { return part.is_number(); })) return e;
    const double value = value_of(e);
    if (!std::isfinite(value)) complain(column, formula_text(e) + " is not a finite number");
    return {Kind::number, std::isfinite(value) ? value : 1.0, {}, {}, column};
  }

  Expression sum() {
    Expression left = product();
    while (is("+") || is("-")) {
      const FormulaToken sign = take();
      Expression right = product();
      const int column = left.column;
      left = made(sign.text == "+" ? Kind::sum : Kind::difference, column, {std::move(left), std::move(right)});
    }
    return left;
  }

  Expression product() {
    Expression left = unary();
    while (is("*") || is("/")) {
      const FormulaToken sign = take();
      Expression right = unary();
      if (sign.text == "/" && right.is_number() && right.number == 0.0) {
        complain(right.column, "a division by 0");
        right.number = 1.0;
      }
      const int column = left.column;
      left = made(sign.text == "*" ? Kind::product : Kind::quotient, column, {std::move(left), std::move(right)});
    }
    return left;
  }

  Expression unary() {
    if (!is("-") && !is("+")) return power();
    const Deeper deeper(*this);
    const FormulaToken sign = take();
    Expression of = unary();
    if (sign.text == "+") return of;
    if (of.kind == Kind::negation)
      return Expression(of.parts.front());  // written out, it would be nested twice as deep
    return made(Kind::negation, sign.column, {std::move(of)});
  }

  Expression power() {
    Expression base = primary();
    if (!is("^")) return base;
    take();
    const int column = base.column, place = now().column;
    const Deeper deeper(*this);
    Expression exponent = unary();
    if (!exponent.is_number()) {
      complain(place, "an exponent must be a number, as in v^2, not " + formula_text(exponent));
      exponent = {Kind::number, 2.0, {}, {}, place};
    }
    return made(Kind::power, column, {std::move(base), std::move(exponent)});
  }

  Expression primary() {
    if (now().kind == FormulaToken::Kind::number) {
      const FormulaToken word = take();
      return {Kind::number, word.number, {}, {}, word.column};
    }
    if (now().kind == FormulaToken::Kind::name) return named();
    if (is("(")) return in_parentheses("this (");
    if (now().kind == FormulaToken::Kind::end)
      fail("the formula ends where a number, q, v, u or a function is expected");
    fail("a number, q, v, u or a function is expected before \"" + now().text + "\"");
  }

  Expression in_parentheses(const std::string& opened) {
    const Deeper deeper(*this);
    const FormulaToken opening = take();
    Expression inner = sum();
    if (now().kind == FormulaToken::Kind::end) {
      complain(opening.column, opened + " has no matching ); add one");
      throw Fault{};
    }
    if (!is(")")) fail("an operator is missing before \"" + now().text + "\"; write products with *");
    take();
    return inner;
  }

  Expression named() {
    const FormulaToken word = take();
    if (is("(")) return call(word);
    if (word.text == "q" || word.text == "v" || word.text == "u")
      return {Kind::variable, 0.0, word.text, {}, word.column};
    if (word.text == "pi") return {Kind::number, 3.14159265358979323846, {}, {}, word.column};
    check_parameter(word);
    return {Kind::parameter, 0.0, word.text, {}, word.column};
  }

  Expression call(const FormulaToken& word) {
    std::vector<std::string> known;
    for (const auto& [name, of] : functions()) known.push_back(name);
    const bool found = functions().contains(word.text);
    if (!found && word.text.size() == 1)
      complain(word.column, "an operator is missing between \"" + word.text + "\" and (; write products with *");
    else if (!found)
      complain(word.column,
               "there is no function " + word.text + did_you_mean(word.text, known) + "; known are " + kFunctionNames);
    Expression argument = in_parentheses("the ( of " + word.text);
    return made(Kind::call, word.column, {std::move(argument)}, found ? word.text : "abs");
  }

  void check_parameter(const FormulaToken& word) {
    const auto is_small = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    if (functions().contains(word.text))
      complain(word.column,
               word.text + " is a function; write its argument in parentheses, as in " + word.text + "(v)");
    else if (!std::all_of(word.text.begin(), word.text.end(), is_small) || word.text.front() == '_')
      complain(word.column, "\"" + word.text + "\" is not a valid parameter name; write small letters, digits and _");
  }

  /// Counts the depth of the recursion, so that no text overflows the stack.
  class Deeper {
   public:
    explicit Deeper(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kDeepest) parser_.fail("the formula is nested too deeply from here on; simplify it");
    }
    ~Deeper() { --parser_.depth_; }

   private:
    Parser& parser_;
  };

  std::vector<FormulaToken> tokens_;
  ProblemList& problems_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::optional<Expression> parse_formula(const std::string& text, ProblemList& problems) {
  if (text.size() > kLongest) {
    problems.add(formula_place(static_cast<int>(kLongest)), "the formula is longer than " + std::to_string(kLongest) +
                                                                " characters; split it into several effects");
    return std::nullopt;
  }
  ProblemList found;
  const std::vector<FormulaToken> tokens = scan_formula(text, found);
  std::optional<Expression> formula;
  if (found.empty()) {
    try {
      formula = Parser(tokens, found).parse();
    } catch (const Fault&) {
    }
  }
  for (const Problem& problem : found.all()) problems.add(problem.location, problem.message);
  return found.empty() ? formula : std::nullopt;
}

}  // namespace lacuna
