#include "baselines/effect_signals.h"

#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kNothing = 1e-6;  ///< of a change: what is left of it is rounding

double cosine(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const double lengths = a.norm() * b.norm();
  return lengths > 0.0 ? a.dot(b) / lengths : 0.0;
}

}  // namespace

std::vector<EffectSignal> effect_signals(const Observed& seen, const BaseFit& base,
                                         const std::vector<Candidate>& candidates, std::size_t tries) {
  const Eigen::MatrixXd directions = base_directions(seen, base);
  const auto projected = [&](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(x - directions * (directions.transpose() * x));
  };
  const Eigen::VectorXd residual = stacked(base.fit.residuals), own = projected(residual);
  const Eigen::VectorXd middle =
      whitened_prediction(seen.base, base.fit.values, seen.trials, base.fit.starts, base.deviations);
  std::vector<EffectSignal> signals;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const PlantModel model = with_law(seen.base, candidates[c].law);
    for (const Try& tried : candidates[c].tries(tries)) {
      EffectSignal signal{c, tried, {}};
      const Eigen::VectorXd there = whitened_prediction(model, with_parameters(base.fit.values, tried.parameters),
                                                        seen.trials, base.fit.starts, base.deviations);
      if (there.size() == middle.size()) {
        signal.change = there - middle;
        signal.correlation = cosine(signal.change, residual);
        const Eigen::VectorXd unlike = projected(signal.change);
        if (unlike.norm() > kNothing * signal.change.norm()) {
          signal.partial = cosine(unlike, own);
          signal.scale = unlike.dot(own) / unlike.squaredNorm();
        }
      }
      signals.push_back(std::move(signal));
    }
  }
  return signals;
}

}  // namespace hidden_effects
