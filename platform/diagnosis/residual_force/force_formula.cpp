#include "diagnosis/residual_force/force_formula.h"

#include "diagnosis/residual_force/force_features.h"
#include "diagnosis/residual_force/force_regression.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kMostTerms = 3;
constexpr double kTermSeen = 0.01;   ///< of a term's power: what the model's own values do not stand for
constexpr double kDifferent = 1e-3;  ///< share of a term that those before it do not span
constexpr double kLeastGain = 3.0;   ///< nats, for a further term

std::vector<Eigen::MatrixXd> responses(const JointMotion& motion, const ForceResponses& forces,
                                       const std::vector<ForceFeature>& features) {
  std::vector<Eigen::MatrixXd> columns;
  for (std::size_t k = 0; k < motion.position.size(); ++k) {
    const Eigen::Index pulses = motion.position[k].size();
    Eigen::MatrixXd values(pulses, static_cast<Eigen::Index>(features.size()));
    for (std::size_t i = 0; i < features.size(); ++i)
      for (Eigen::Index p = 0; p < pulses; ++p)
        values(p, static_cast<Eigen::Index>(i)) = features[i].of(motion.position[k](p), motion.velocity[k](p),
                                                                 motion.command.empty() ? 0.0 : motion.command[k](p));
    columns.emplace_back(forces.of[k][motion.index] * values);
  }
  return columns;
}

/// The feature that predicts the left-out folds best beside `terms`, better than with these alone; −1: none does.
Eigen::Index next_term(const ForceRegression& regression, const ForceRegression::Columns& terms, double deviance) {
  Eigen::Index best = -1;
  for (Eigen::Index i = 0; i < regression.count(); ++i) {
    if (!(regression.seen(i) > kTermSeen) || regression.share_beside(i, terms) < kDifferent) continue;
    ForceRegression::Columns more = terms;
    more.push_back(i);
    const double tried = regression.held_out(more).sum();
    if (!(tried < deviance)) continue;
    deviance = tried;
    best = i;
  }
  return best;
}

ForceFormula formula_of(const ForceTask& task, const JointMotion& motion, const ForceResponses& forces) {
  const std::vector<ForceFeature> features = force_features(motion);
  ForceRegression regression(task.base, task.factors, responses(motion, forces, features), task.folds);
  ForceFormula formula{motion.joint, motion.force_unit, {}, {}, {}};
  ForceRegression::Columns terms;
  const Eigen::VectorXd plain = regression.held_out(terms);
  formula.held_out = plain;
  while (terms.size() < kMostTerms) {
    const Eigen::Index best = next_term(regression, terms, formula.held_out.sum());
    if (best < 0) break;
    ForceRegression::Columns more = terms;
    more.push_back(best);
    ForceRegression longer = regression;
    longer.settle(more);
    const Eigen::VectorXd held_out = longer.held_out(more);
    const Gain further = gain(formula.held_out, held_out, task.seed);
    if (further.value < std::max(kLeastGain, 2.0 * further.standard_error)) break;
    terms = std::move(more);
    regression = std::move(longer);
    formula.held_out = held_out;
  }
  if (terms.empty()) return formula;
  formula.gain = gain(plain, formula.held_out, task.seed);
  const Eigen::VectorXd sizes = regression.sizes(terms);
  const Eigen::MatrixXd covariance = regression.covariance(terms);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const ForceFeature& feature = features[static_cast<std::size_t>(terms[i])];
    const auto j = static_cast<Eigen::Index>(i);
    formula.terms.push_back({feature.text, feature.unit, sizes(j), std::sqrt(covariance(j, j))});
  }
  return formula;
}

}  // namespace

std::string ForceFormula::text() const {
  std::string text;
  for (const Term& term : terms) {
    const std::string size = fmt::format("{:.4g}", std::abs(term.coefficient));
    text += text.empty() ? (term.coefficient < 0.0 ? "-" : "") : (term.coefficient < 0.0 ? " - " : " + ");
    text += term.text == "1" ? size : size + "*" + term.text;
  }
  return text;
}

std::vector<ForceFormula> find_formulas(const ForceTask& task, const std::vector<JointMotion>& motions,
                                        const ForceResponses& forces) {
  std::vector<ForceFormula> formulas;
  for (const JointMotion& motion : motions) {
    ForceFormula formula = formula_of(task, motion, forces);
    if (!formula.terms.empty()) formulas.push_back(std::move(formula));
  }
  std::stable_sort(formulas.begin(), formulas.end(),
                   [](const ForceFormula& a, const ForceFormula& b) { return a.gain.value > b.gain.value; });
  return formulas;
}

}  // namespace lacuna
