#pragma once

#include "residual_law/force_findings.h"
#include "residual_law/law_bench.h"

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// With its 95 % interval.
Gain in_nats(const CostGain& gain);

/// Laws of free form on one joint beside a fitted model, of every family and of several together, each with some
/// ridges. What is referred to must outlive it.
class JointLaws {
 public:
  /// `linear`: the model on the ladder, at its fitted values and starts.
  JointLaws(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder,
            const LinearPrediction& linear, const JointCourse& course);

  const JointCourse& course() const { return course_; }
  const std::vector<FittedLaw>& laws() const { return laws_; }  ///< none where the model cannot feel such a force
  const FittedLaw& plain() const { return plain_; }             ///< the model without one
  /// Whether the part of a law that depends on the velocity, now or before, adds energy to the joint. Random forces
  /// produce such laws, because a joint moves where they push it; friction does not.
  bool drives(const FittedLaw& law) const;

  /// The force over each quantity that alone gains more than its error, and over velocity at some positions.
  std::vector<ForceCurve> curves() const;
  /// The force over each quantity that alone gains more than its error, with what the same law makes of other residuals
  /// of the model, `part`, as `by_answer`.
  std::vector<ForceCurve> curves_beside(const LinearPrediction& part) const;
  /// Physical terms one by one, each the one with which most is gained, while that is worth it; `whole_gain`: nats, of
  /// the best law. None where no term is.
  std::vector<ForceFormula> formulas(double whole_gain) const;

 private:
  void add(const std::string& kind, const std::vector<std::size_t>& functions);
  CostGain gain(const FittedLaw& law) const { return gain_of(law.judged, plain_.judged); }
  const FittedLaw& best_of(const std::string& kind) const;
  ForceCurve curve_over(const LawFamily& family, const FittedLaw& law) const;
  void trace(const FittedLaw& law, const std::vector<JointMoment>& moments, ForceCurve& curve) const;
  /// What each function of a law is at a moment.
  Eigen::VectorXd functions_at(const FittedLaw& law, const JointMoment& moment) const;
  std::optional<ForceCurve> slice_at(double position, const FittedLaw& law) const;
  ForceFormula formula_of(const LawBench& bench, const FittedLaw& law, const std::vector<ForceTerm>& terms) const;

  const PredictionLadder& ladder_;
  const LinearPrediction& linear_;
  const FittedModel& model_;
  const JointCourse& course_;
  ForcePulses pulses_;
  std::vector<LawFamily> families_;
  LawBench::Functions functions_;     ///< of all families
  std::vector<char> is_of_velocity_;  ///< by function: of a family that follows the velocity
  std::optional<LawBench> bench_;
  FittedLaw plain_;
  std::vector<FittedLaw> laws_;
};

}  // namespace lacuna
