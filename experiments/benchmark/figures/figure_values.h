#pragma once

#include "figures/estimate.h"
#include "runs/database.h"

#include <functional>
#include <string>
#include <vector>

namespace hidden_effects {

/// A row of the view `figure`. NaN: the goal has no such end.
struct FigureKind {
  std::string name, title, kind;
  double least = 0.0, most = 0.0;
  bool has_goal() const;
  bool met_by(double value) const;
};

/// A row of the view `figure_value` with what its case is of.
struct FigureValue {
  std::string figure;
  double value = 0.0, probability = 0.0;
  std::string noise, strength, rig, effect, form;
};

/// What the cases of a set give, of one version of the method or of several together.
struct FigureValues {
  std::vector<std::string> versions;  ///< oldest first
  std::string set;
  std::vector<FigureKind> figures;
  std::vector<FigureValue> values;
  std::size_t cases = 0;         ///< but for those `not_withheld`; what several versions met counts once for each
  std::size_t made = 0;          ///< of these; the others could not be
  std::size_t not_withheld = 0;  ///< cases that count nowhere: a right answer was left in the library
};

/// "version a", "versions a and b", "11 versions".
std::string version_text(const FigureValues& all);

/// Of a set, oldest first.
std::vector<std::string> versions_of(const Database& database, const std::string& set);

/// The version that was begun last among those that have the set. Throws `std::invalid_argument` where none has.
std::string last_version(const Database& database, const std::string& set);

/// Without any version: of the one that was begun last. Throws `std::invalid_argument` where the database has no case
/// of one of them.
FigureValues read_figures(const Database& database, const std::vector<std::string>& versions, const std::string& set);

/// One figure over the values that `chosen` takes.
Estimate estimate_of(const FigureValues& all, const FigureKind& figure,
                     const std::function<bool(const FigureValue&)>& chosen);

}  // namespace hidden_effects
