#pragma once

#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

inline const EffectAt kCoulomb{"coulomb_friction", "joint.hinge"};
inline const EffectAt kStribeck{"stribeck_friction", "joint.hinge"};
inline const EffectAt kSpring{"joint_spring", "joint.hinge"};

/// A case of version "v" and set "tuning" that hides effects in the library's form, each with a parameter `size` of 2.
inline CaseResult small_case(int number, const std::string& group, const std::vector<EffectAt>& hidden,
                             double strength = 3.0) {
  CaseResult result;
  result.about = {"v", "tuning", number, group, "servo_pendulum", "disturbed", strength, strength, false, "7", {}};
  for (const EffectAt& what : hidden) result.about.hidden.push_back({what.effect, what, true, {{"size", 2.0}}});
  return result;
}

/// A diagnosis whose first model has `effects` and `look_alikes` of the last of them.
inline DiagnosisRecord small_diagnosis(int round, const std::string& verdict, double probability,
                                       const std::vector<EffectAt>& effects = {},
                                       const std::vector<EffectAt>& look_alikes = {}) {
  DiagnosisRecord diagnosis;
  diagnosis.round = round;
  diagnosis.verdict = verdict;
  diagnosis.probability = probability;
  diagnosis.seconds = 10.0 * round;
  diagnosis.json = "{}";
  if (effects.empty()) return diagnosis;
  RankedModelRecord model;
  for (const EffectAt& what : effects) model.effects.push_back({what, {{"size", 2.0, 1.0, 3.0}}});
  model.look_alikes = look_alikes;
  diagnosis.ranking.push_back(model);
  return diagnosis;
}

}  // namespace hidden_effects
