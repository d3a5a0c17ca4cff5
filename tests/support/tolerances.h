#pragma once

/// Tolerances that several tests share; each says what it has to cover.
namespace lacuna {

/// Local error of the reference integrations, absolute and relative: far below every other one.
inline constexpr double kReferenceTolerance = 1e-11;

/// Results that differ by rounding alone after some thousand steps.
inline constexpr double kRounding = 1e-9;

/// An error that is no more than rounding.
inline constexpr double kExact = 1e-10;

/// A method of first order halves its error with its step, one of second quarters it; the next order shifts the ratio a
/// little.
inline constexpr double kHalvingRatioLow = 1.8;

}  // namespace lacuna
