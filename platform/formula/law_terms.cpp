#include "formula/law_terms.h"

#include <cctype>
#include <utility>

namespace lacuna {
namespace {

using Kind = Expression::Kind;

constexpr std::size_t kLongestName = 24;  ///< characters; for longer names a number is clearer

void split_product(const Expression& e, bool inverse, RawTerm& term) {
  switch (e.kind) {
    case Kind::number: term.number = inverse ? term.number / e.number : term.number * e.number; return;
    case Kind::negation:
      term.number = -term.number;
      split_product(e.parts[0], inverse, term);
      return;
    case Kind::product:
    case Kind::quotient:
      split_product(e.parts[0], inverse, term);
      split_product(e.parts[1], inverse != (e.kind == Kind::quotient), term);
      return;
    default: (inverse ? term.under : term.over).push_back(e); return;
  }
}

void split_sum(const Expression& e, double sign, std::vector<RawTerm>& terms) {
  if (e.kind == Kind::sum || e.kind == Kind::difference) {
    split_sum(e.parts[0], sign, terms);
    split_sum(e.parts[1], e.kind == Kind::sum ? sign : -sign, terms);
    return;
  }
  RawTerm& term = terms.emplace_back();
  term.number = sign;
  term.column = e.column;
  split_product(e, false, term);
}

}  // namespace

Expression RawTerm::rest() const {
  Expression product{Kind::number, 1.0, {}, {}, column};
  for (const Expression& factor : over)
    product = product.is_number() ? factor : Expression{Kind::product, 0.0, {}, {product, factor}, column};
  for (const Expression& divisor : under) product = Expression{Kind::quotient, 0.0, {}, {product, divisor}, column};
  return product;
}

std::vector<RawTerm> terms_of(const Expression& formula) {
  std::vector<RawTerm> terms;
  split_sum(formula, 1.0, terms);
  return terms;
}

std::string name_of_factor(const Expression& rest) {
  if (rest.is_number()) return "constant";
  const std::string text = formula_text(rest);
  std::string name = "c";
  bool joined = false;  // attached to the character before, as the 3 to the q of 3*q and the 2 to the q of q^2
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    if (!letter && std::string("*^()").find(c) == std::string::npos) return {};
    if (!letter) {
      const bool after_number =
          c == '*' && i > 0 && std::isdigit(static_cast<unsigned char>(text[i - 1])) && (i < 2 || text[i - 2] == '(');
      joined = c == '^' || after_number;
      continue;
    }
    const bool begins = i == 0 || !(std::isalnum(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == '_');
    if (begins && !joined) name += '_';
    name += c;
  }
  return name.size() > kLongestName ? std::string{} : name;
}

}  // namespace lacuna
