#pragma once

namespace hidden_effects {

/// Of differences that stand for derivatives: a share of a value, at least `kLeastStep`; of a start, rad or m, and per
/// s.
inline constexpr double kRelativeStep = 1e-4, kLeastStep = 1e-7, kStartStep = 1e-5;

}  // namespace hidden_effects
