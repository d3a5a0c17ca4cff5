#pragma once

#include "cases/make_case.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// All that a baseline may see of a case: what the program gets, too. The truth, clean readings, the noise's sizes and
/// held-out trials are not in here, and nothing in this folder but `observed` takes a `MadeCase`.
struct Observed {
  PlantModel base;                    ///< as its user wrote it down: no laws, free values nominal
  std::vector<FittedTrial> trials;    ///< recorded commands and readings of the trials to fit, two or more
  std::vector<std::string> withheld;  ///< effects that the library is to do without

  Eigen::VectorXd nominal() const;  ///< the free values as written down
};

/// The recorded side of a case. Throws `std::invalid_argument` for fewer than two trials to fit, for trials cannot be
/// left out then.
Observed observed(const MadeCase& made, std::vector<std::string> withheld = {});

}  // namespace hidden_effects
