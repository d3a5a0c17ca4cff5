#pragma once

#include <cstdint>

namespace lacuna {

/// What the score of a model is.
enum class ScoreKind : std::uint8_t {
  full,       ///< every trial was scored to its end
  abandoned,  ///< a lower bound: the evaluation ended when it could not get under its generation's bar
  invalid     ///< none (in a sum: infinite): NaN, explosion, an engine's error, a plugin's exception; a reason is given
};

}  // namespace lacuna
