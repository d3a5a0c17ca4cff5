#pragma once

#include "cases/make_case.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// Two models are told apart by data whose whitened predictions, refitted, differ by that sum of squares.
inline constexpr double kToldApart = 4.0;

/// Where somebody says that a law explains the data.
struct KnownStart {
  PlacedLaw law;
  std::vector<double> parameters;
};

struct OracleOptions {
  std::vector<std::string> among = {};  ///< effects that are tried; empty: all
  std::vector<KnownStart> known = {};   ///< fits of rivals begin there, too, beside the own starts; none is given up
  double step = 1e-3;                   ///< s, of all predictions, the truth's too: so the integrator's error drops out
  std::size_t most_shapes = 6;          ///< of a law, in the linear screening
  std::size_t most_refined = 3;         ///< starts of a rival
  int most_iterations = 25;
  double hopeless = 0.1;        ///< of the deviance: a fit that an iteration helps less than that is given up
  double refined_below = 60.0;  ///< of a linear estimate of the non-centrality beyond the representative's, and
  double refined_share = 0.7;   ///< of what the base alone would leave; the larger counts
};

/// A law in the place of a hidden one, and what is left of the noise-free data by the best fit that was found.
struct Rival {
  PlacedLaw law;
  double non_centrality = 0.0;  ///< where nothing was refined, the linear lower estimate
  bool refined = false;
  bool told_apart = true;  ///< from the truth
};

/// Nothing in the place of a hidden law, other hidden laws staying; where it is alone, the base.
struct Absence {
  double non_centrality = 0.0;
  bool told_apart = true;  ///< from the truth, or, of two laws, from their representative
};

struct Width {
  std::string parameter;  ///< an address of the base, or "coulomb_friction.torque"
  double value = 0.0;
  double width = 0.0;  ///< of the 95 % interval; infinite where the data say nothing
};

/// What the fit trials of a case could tell at all.
struct OracleAnswer {
  double base_non_centrality = 0.0;
  bool detectable = false;      ///< the truth is told from the base
  double non_centrality = 0.0;  ///< of the truth's representative in the library; 0 where the truth is of its form
  std::vector<PlacedLaw> representative;
  std::vector<Absence> absences;           ///< by hidden law of the case
  std::vector<std::vector<Rival>> rivals;  ///< by hidden law of the case, the least non-centrality first
  std::vector<Width> widths;               ///< of the representative's values

  /// The members of a hidden law's class besides itself.
  std::vector<PlacedLaw> alike(std::size_t hidden) const;
};

/// With the truth known and no noise in the data: non-centralities are least sums of squares, whitened by the true
/// covariance of the noise, of what a model leaves of the truth's predictions when all that is free is refitted: the
/// base's values, the starts and the rival's parameters (the other hidden law's too). Every law of the library is
/// tried at every place; linearly first (one prediction a start, its size chosen so that it explains most, the
/// derivatives of everything else projected out), the promising ones by fits. A least sum of squares that is not
/// found counts as told apart: so classes are too small rather than too large.
OracleAnswer ask_oracle(const MadeCase& made, const OracleOptions& options = {});

}  // namespace hidden_effects
