#include "residual_law/force_findings.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {

std::string ForceFormula::text() const {
  std::string text;
  for (const Term& term : terms) {
    const std::string size = fmt::format("{:.4g}", std::abs(term.coefficient));
    text += text.empty() ? (term.coefficient < 0.0 ? "-" : "") : (term.coefficient < 0.0 ? " - " : " + ");
    text += term.text == "1" ? size : size + "*" + term.text;
  }
  return text;
}

}  // namespace lacuna
