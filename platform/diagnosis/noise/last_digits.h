#pragma once

namespace lacuna {

/// What another machine's last digits may move figures of a diagnosis by, as a share: searches, substeps and refits end
/// where the next step gains less than a tolerance, and a difference of rounding ends them elsewhere by as much. A
/// little more than what one unit in the last digit of a measured rig's readings did (docs/explanation/diagnosis.md,
/// "At a threshold").
inline constexpr double kLastDigits = 0.1;          ///< of a gain and its standard error
inline constexpr double kLastDigitsOfScore = 0.02;  ///< of the deviance that is held against chance
inline constexpr double kLastDigitsOfError = 0.01;  ///< of an error over the floor

/// A figure and between what it may lie on another machine.
struct VerdictFigure {
  double value = 0.0, low = 0.0, high = 0.0;
};

}  // namespace lacuna
