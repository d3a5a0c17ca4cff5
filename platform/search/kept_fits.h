#pragma once

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// Values by name: an address of the model's own, or "effect @ place.parameter".
using NamedValues = std::map<std::string, double>;

/// The fitted values of a set of effects.
struct KeptFit {
  NamedValues values;
  std::vector<Eigen::VectorXd> starts;  ///< by stretch
  bool operator==(const KeptFit&) const = default;
};

/// By "N lengths: effect @ place + effect @ place". A later search for the same task starts from them.
using KeptFits = std::map<std::string, KeptFit>;

}  // namespace lacuna
