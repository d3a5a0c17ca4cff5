#pragma once

#include "residual_law/force_findings.h"
#include "residual_law/law_context.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// With its 95 % interval.
Gain in_nats(const CostGain& gain);

/// Nonparametric force laws on one joint beside a fitted model, of every family and of several together, each with some
/// ridge penalties. Everything that it refers to must outlive it.
class JointLaws {
 public:
  /// `linear`: the model linearised on the ladder, at its fitted values and initial states.
  JointLaws(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder,
            const LinearPrediction& linear, const JointCourse& course);

  const JointCourse& course() const { return course_; }
  const std::vector<FittedLaw>& laws() const { return laws_; }  ///< none where a force on this joint changes no reading
  const FittedLaw& plain() const { return plain_; }             ///< the model without a law
  /// Whether the part of a law that depends on the velocity, now or before, adds energy to the joint. Random forces
  /// produce such laws, because a joint moves where they push it; friction does not.
  bool drives(const FittedLaw& law) const;

  /// The force over each quantity whose curve alone gains more than its error, and over velocity at some positions.
  std::vector<ForceCurve> curves() const;
  /// The same, with the law of another residual of the model, `part`, as `by_answer`.
  std::vector<ForceCurve> curves_beside(const LinearPrediction& part) const;
  /// Adds physical terms one by one, each time the one with the largest gain, while the gain justifies it;
  /// `whole_gain`: of the best law, nats. Empty where no term is worth its cost.
  std::vector<ForceFormula> formulas(double whole_gain) const;

 private:
  void add(const std::string& kind, const std::vector<std::size_t>& functions);
  CostGain gain(const FittedLaw& law) const { return gain_of(law.judged, plain_.judged); }
  const FittedLaw& best_of(const std::string& kind) const;
  ForceCurve curve_over(const LawFamily& family, const FittedLaw& law) const;
  void trace(const FittedLaw& law, const std::vector<JointMoment>& moments, ForceCurve& curve) const;
  /// Value of each function of a law at one moment.
  Eigen::VectorXd functions_at(const FittedLaw& law, const JointMoment& moment) const;
  std::optional<ForceCurve> slice_at(double position, const FittedLaw& law) const;
  ForceFormula formula_of(const LawContext& context, const FittedLaw& law, const std::vector<ForceTerm>& terms) const;

  const PredictionLadder& ladder_;
  const LinearPrediction& linear_;
  const FittedModel& model_;
  const JointCourse& course_;
  ForcePulses pulses_;
  std::vector<LawFamily> families_;
  LawContext::Functions functions_;   ///< of all families
  std::vector<char> is_of_velocity_;  ///< by function: whether its family depends on the velocity
  std::optional<LawContext> context_;
  FittedLaw plain_;
  std::vector<FittedLaw> laws_;
};

}  // namespace lacuna
