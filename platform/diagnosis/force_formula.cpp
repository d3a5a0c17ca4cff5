#include "diagnosis/force_formula.h"

#include "diagnosis/force_features.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kMostTerms = 3;
constexpr double kTermSeen = 0.01;   ///< of a term's power: what the model's own values do not stand for
constexpr double kDifferent = 1e-3;  ///< share of a term that those before it do not span
constexpr double kLeastGain = 3.0;   ///< nats, for a further term

/// Normal equations by fold.
class FoldedRegression {
 public:
  FoldedRegression(const WhitenedSegments& whitened, const std::vector<std::size_t>& folds, Eigen::MatrixXd columns)
      : whitened_(whitened), folds_(folds), columns_(std::move(columns)) {
    const std::size_t last = folds.empty() ? 0 : *std::max_element(folds.begin(), folds.end());
    gram_.assign(last + 1, Eigen::MatrixXd::Zero(columns_.cols(), columns_.cols()));
    score_.assign(last + 1, Eigen::VectorXd::Zero(columns_.cols()));
    for (std::size_t k = 0; k < folds.size(); ++k) {
      gram_[folds[k]] += part(k).transpose() * part(k);
      score_[folds[k]] += part(k).transpose() * residual(k);
    }
    all_gram_ = gram_.front();
    all_score_ = score_.front();
    for (std::size_t f = 1; f < gram_.size(); ++f) {
      all_gram_ += gram_[f];
      all_score_ += score_[f];
    }
  }

  const Eigen::MatrixXd& gram() const { return all_gram_; }

  /// By segment; nothing where the terms are not told apart without a fold.
  Eigen::VectorXd held_out(const std::vector<Eigen::Index>& terms) const {
    Eigen::VectorXd deviance(static_cast<Eigen::Index>(folds_.size()));
    for (std::size_t f = 0; f < gram_.size(); ++f) {
      const Eigen::LDLT<Eigen::MatrixXd> solver((all_gram_ - gram_[f])(terms, terms));
      const Eigen::VectorXd sizes = solver.solve((all_score_ - score_[f])(terms));
      for (std::size_t k = 0; k < folds_.size(); ++k)
        if (folds_[k] == f)
          deviance(static_cast<Eigen::Index>(k)) = (residual(k) - part(k)(Eigen::all, terms) * sizes).squaredNorm();
    }
    return deviance;
  }

  /// Share of a column that `terms` do not span.
  double share_beside(Eigen::Index column, const std::vector<Eigen::Index>& terms) const {
    if (terms.empty()) return 1.0;
    const Eigen::VectorXd mixed = all_gram_(terms, column);
    const Eigen::LDLT<Eigen::MatrixXd> solver(all_gram_(terms, terms));
    return 1.0 - mixed.dot(solver.solve(mixed)) / all_gram_(column, column);
  }

  Eigen::VectorXd sizes(const std::vector<Eigen::Index>& terms) const {
    return all_gram_(terms, terms).ldlt().solve(Eigen::VectorXd(all_score_(terms)));
  }
  Eigen::MatrixXd covariance(const std::vector<Eigen::Index>& terms) const {
    return Eigen::MatrixXd(all_gram_(terms, terms)).inverse();
  }

 private:
  Eigen::Index rows(std::size_t k) const { return whitened_.first(k + 1) - whitened_.first(k); }
  Eigen::MatrixXd::ConstRowsBlockXpr part(std::size_t k) const {
    return columns_.middleRows(whitened_.first(k), rows(k));
  }
  Eigen::VectorXd residual(std::size_t k) const { return whitened_.residual().segment(whitened_.first(k), rows(k)); }

  const WhitenedSegments& whitened_;
  const std::vector<std::size_t>& folds_;
  Eigen::MatrixXd columns_;
  std::vector<Eigen::MatrixXd> gram_;
  std::vector<Eigen::VectorXd> score_;
  Eigen::MatrixXd all_gram_;
  Eigen::VectorXd all_score_;
};

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

ForceFormula formula_of(const WhitenedSegments& whitened, const JointMotion& motion, const ForceResponses& forces,
                        const std::vector<std::size_t>& folds, std::uint64_t seed) {
  const std::vector<ForceFeature> features = force_features(motion);
  const std::vector<Eigen::MatrixXd> columns = responses(motion, forces, features);
  const Eigen::VectorXd power = whitened.whiten(columns).colwise().squaredNorm();
  const FoldedRegression regression(whitened, folds, whitened.project(columns));
  const Eigen::VectorXd plain = regression.held_out({});
  ForceFormula formula{motion.joint, motion.force_unit, {}, {}, {}};
  std::vector<Eigen::Index> terms;
  Eigen::VectorXd deviance = plain;
  while (terms.size() < kMostTerms) {
    Eigen::Index best = -1;
    Eigen::VectorXd least = deviance;
    for (Eigen::Index i = 0; i < power.size(); ++i) {
      if (!(regression.gram()(i, i) > kTermSeen * power(i)) || regression.share_beside(i, terms) < kDifferent) continue;
      std::vector<Eigen::Index> more = terms;
      more.push_back(i);
      const Eigen::VectorXd tried = regression.held_out(more);
      if (!(tried.sum() < least.sum())) continue;
      least = tried;
      best = i;
    }
    if (best < 0) break;
    const Gain further = gain(deviance, least, seed);
    if (further.value < std::max(kLeastGain, 2.0 * further.standard_error)) break;
    terms.push_back(best);
    deviance = least;
  }
  if (terms.empty()) return formula;
  formula.gain = gain(plain, deviance, seed);
  formula.held_out = deviance;
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

std::vector<ForceFormula> find_formulas(const WhitenedSegments& whitened, const std::vector<JointMotion>& motions,
                                        const ForceResponses& forces, const std::vector<std::size_t>& folds,
                                        std::uint64_t seed) {
  std::vector<ForceFormula> formulas;
  for (const JointMotion& motion : motions) {
    ForceFormula formula = formula_of(whitened, motion, forces, folds, seed);
    if (!formula.terms.empty()) formulas.push_back(std::move(formula));
  }
  std::stable_sort(formulas.begin(), formulas.end(),
                   [](const ForceFormula& a, const ForceFormula& b) { return a.gain.value > b.gain.value; });
  return formulas;
}

}  // namespace lacuna
