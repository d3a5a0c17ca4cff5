#include "residual_law/law_context.h"

#include "criterion/value_errors.h"
#include "prediction/whitened_columns.h"

#include <limits>
#include <numeric>
#include <utility>

namespace lacuna {
namespace {

/// Means of the functions over each pulse of a stretch: pulses × functions.
Eigen::MatrixXd at_pulses(const PredictedStretch& stretch, const JointCourse& course,
                          const std::vector<std::pair<Eigen::Index, Eigen::Index>>& pulses,
                          const LawContext::Functions& functions) {
  const std::vector<JointMoment>& moments = course.trials[stretch.stretch.trial];
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(pulses.size()), static_cast<Eigen::Index>(functions.size()));
  for (std::size_t p = 0; p < pulses.size(); ++p) {
    const auto [first, end] = pulses[p];
    for (std::size_t f = 0; f < functions.size(); ++f) {
      double sum = 0.0;
      for (Eigen::Index i = first; i < end; ++i)
        sum += functions[f](moments[static_cast<std::size_t>(stretch.stretch.first + i)]);
      if (first < end)
        values(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(f)) = sum / static_cast<double>(end - first);
    }
  }
  return values;
}

}  // namespace

LawContext::LawContext(const PredictionLadder& ladder, const LinearPrediction& linear, const StepBounds& bounds,
                       const JointCourse& course, const ForcePulses& pulses, const Functions& functions)
    : layout_(ladder.layout), bounds_(bounds) {
  std::vector<LinearStretch> stretches = linear.stretches;
  const auto count = static_cast<Eigen::Index>(functions.size());
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    Eigen::MatrixXd& values = stretches[k].values;
    values.conservativeResize(Eigen::NoChange, values.cols() + count);
    values.rightCols(count) =
        pulses.responses[k] * at_pulses(ladder.stretches[k], course, pulses.samples[k], functions);
  }
  products_ = whitened_products(ladder, stretches);
}

BlockProducts LawContext::products_of(const std::vector<std::size_t>& functions) const {
  std::vector<Eigen::Index> values(static_cast<std::size_t>(bounds_.lower.size()));
  std::iota(values.begin(), values.end(), Eigen::Index{0});
  for (const std::size_t function : functions)
    values.push_back(bounds_.lower.size() + static_cast<Eigen::Index>(function));
  return products_.part(values);
}

/// Functions may have any size.
StepBounds LawContext::bounds_of(const FittedLaw& law) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Eigen::Index own = bounds_.lower.size(), all = own + static_cast<Eigen::Index>(law.functions.size());
  StepBounds bounds{Eigen::VectorXd::Constant(all, -kNone), Eigen::VectorXd::Constant(all, kNone),
                    Eigen::VectorXd::Zero(all)};
  bounds.lower.head(own) = bounds_.lower;
  bounds.upper.head(own) = bounds_.upper;
  bounds.ridge.tail(all - own).setConstant(law.ridge);
  return bounds;
}

FittedLaw LawContext::fit(const std::string& kind, const std::vector<std::size_t>& functions, double ridge) const {
  return std::move(fits(kind, functions, {&ridge, 1}).front());
}

std::vector<FittedLaw> LawContext::fits(const std::string& kind, const std::vector<std::size_t>& functions,
                                        std::span<const double> ridges) const {
  std::vector<FittedLaw> laws;
  const BlockProducts products = products_of(functions);
  for (const double ridge : ridges) {
    FittedLaw& law = laws.emplace_back(FittedLaw{kind, functions, ridge, {}, {}});
    const StepBounds bounds = bounds_of(law);
    law.fit = least_cost(layout_, products, bounds);
    law.judged.members = {law.kind};
    law.judged.mean_square = law.fit.mean_square;
    law.judged.cost = cross_fit(layout_, products, bounds, law.fit, true);
  }
  return laws;
}

Eigen::MatrixXd LawContext::covariance(const FittedLaw& law) const {
  const auto count = static_cast<Eigen::Index>(law.functions.size());
  return value_errors(layout_, products_of(law.functions), law.fit, bounds_of(law).ridge)
      .covariance.bottomRightCorner(count, count);
}

Eigen::VectorXd LawContext::sizes(const FittedLaw& law) const {
  return law.fit.step.tail(static_cast<Eigen::Index>(law.functions.size()));
}

}  // namespace lacuna
