#pragma once

#include "residual_law/force_findings.h"
#include "residual_law/joint_laws.h"
#include "search/effect_search.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What a fitted set leaves that goes with the motion of a joint: a force that no effect of the library has.
struct ResidualLaw {
  bool is_present = false;
  double p = 1.0;                      ///< how often chance alone would gain as much as the best law does
  CostGain gain;                       ///< over `beside`, or over `candidate`
  double share = 0.0;                  ///< of all that this set and the law gain together
  bool is_minor = true;                ///< beside what this set explains (criterion/decision.h)
  std::string joint;                   ///< on which it acts, without "joint."
  std::string kind;                    ///< what it goes with: "position and velocity"
  std::vector<ForceCurve> curves;      ///< over each quantity that alone gains more than its error
  std::vector<ForceFormula> formulas;  ///< of few physical terms; none where no term gains
};

/// Laws of free form on every joint, functions of position, velocity, command, time and their past, by the criterion of
/// the search and at its answer's own lengths, cross-fitted as it is, beside one of its sets, where the recordings hold
/// eight times the shortest length. What it is made of must outlive it.
///
/// The formula: sparse regression over candidate terms (S. L. Brunton, J. L. Proctor and J. N. Kutz, PNAS 113 (2016)
/// 3932-3937), here through the model's own responses, so that nothing is differentiated.
class ResidualLaws {
 public:
  ResidualLaws(const SearchResult& found, const FittedModel& beside);
  ResidualLaws(const ResidualLaws&) = delete;
  ResidualLaws& operator=(const ResidualLaws&) = delete;

  /// The law that gains most. Present: signs with the maximum over all laws below 5 %, more than its error, at more
  /// than one length, a twentieth of all that is gained, and a twentieth of the error at one length. Laws of the
  /// velocity that add energy to the joint are rejected. With a `candidate` all this is asked of what the laws gain
  /// over that set instead: whether a law explains more than it.
  ResidualLaw best(const FittedModel* candidate = nullptr) const;

 private:
  const SearchResult& found_;
  const FittedModel& beside_;
  std::vector<JointCourse> courses_;
  std::optional<LinearPrediction> linear_;          ///< of `beside`
  std::vector<std::unique_ptr<JointLaws>> joints_;  ///< none where nothing is left to a law
};

}  // namespace lacuna
