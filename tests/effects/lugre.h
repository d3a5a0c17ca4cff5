#pragma once

#include <lacuna/physical_effect.h>

namespace lacuna {

/// Test-only: LuGre friction in a joint of one coordinate (C. Canudas de Wit, H. Olsson, K. J. Åström, P. Lischinsky,
/// IEEE Trans. Automatic Control 40 (1995) 419):
///   dz/dt = v − σ0·|v|/g(v)·z,  g(v) = Fc + (Fs − Fc)·exp(−(v/vs)²),  F = −(σ0·z + σ1·dz/dt + σ2·v).
/// The bristle z is integrated with the coming velocity, D = 1 + h·σ0·|v|/g(v) with the present one, so that the
/// engine can take the part that is linear in the coming velocity implicitly: z' = (z + h·v')/D.
///
/// State per joint: z (m or rad) and D of the present step.
class LuGre : public PhysicalEffect {
 public:
  enum Parameter { sigma0, sigma1, sigma2, coulomb, stiction, stribeck_velocity };

  EffectDescription describe() const override;
  EffectHooks hooks() const override { return {.before_step = true, .after_step = true}; }
  int state_size(const EffectContext& context) const override { return 2 * static_cast<int>(context.elements.size()); }
  void before_step(const StepView& view, const EffectContext& context, std::span<double> state,
                   StepLoads& loads) const override;
  void after_step(const StepView& view, const EffectContext& context, std::span<double> state) const override;
};

}  // namespace lacuna
