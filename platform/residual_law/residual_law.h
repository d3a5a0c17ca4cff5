#pragma once

#include "residual_law/force_findings.h"
#include "residual_law/joint_laws.h"
#include "search/effect_search.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// The part of a fitted set's residual that depends on the motion of a joint: a force that no effect of the library
/// describes.
struct ResidualLaw {
  bool is_present = false;
  double p = 1.0;                      ///< probability that chance alone gains as much as the best law
  CostGain gain;                       ///< over `beside`, or over `candidate`
  double share = 0.0;                  ///< share of the gain of this set and the law together
  bool is_minor = true;                ///< beside this set (criterion/decision.h)
  std::string joint;                   ///< joint on which it acts, without "joint."
  std::string kind;                    ///< quantities that it depends on: "position and velocity"
  std::vector<ForceCurve> curves;      ///< over each quantity whose curve alone gains more than its error
  std::vector<ForceFormula> formulas;  ///< of few physical terms; none where no term gains
};

/// Fits nonparametric laws on every joint, functions of position, velocity, command, time and their past, beside one of
/// the sets. They use the criterion of the search, the lengths of its answer and the same cross-fitting, and need
/// recordings eight times as long as the shortest length. The arguments must outlive it.
///
/// The formula: sparse regression over candidate terms (S. L. Brunton, J. L. Proctor and J. N. Kutz, PNAS 113 (2016)
/// 3932-3937), here through the model's own responses, so that no measurement is differentiated.
class ResidualLaws {
 public:
  ResidualLaws(const SearchResult& found, const FittedModel& beside);
  ResidualLaws(const ResidualLaws&) = delete;
  ResidualLaws& operator=(const ResidualLaws&) = delete;

  /// The law that gains most. It is present if chance alone, by random signs with the maximum over all laws, gains as
  /// much with a probability below 5 %; if it gains more than its error, at more than one length; and if the gain is at
  /// least a twentieth of the total gain and of the error at one length. Laws of the velocity that add energy to the
  /// joint are rejected. With a `candidate` the same tests apply to the gain over that set: whether a law explains more
  /// than it.
  ResidualLaw best(const FittedModel* candidate = nullptr) const;

 private:
  const SearchResult& found_;
  const FittedModel& beside_;
  std::vector<JointCourse> courses_;
  std::optional<LinearPrediction> linear_;          ///< of `beside`
  std::vector<std::unique_ptr<JointLaws>> joints_;  ///< none where nothing is left to a law
};

}  // namespace lacuna
