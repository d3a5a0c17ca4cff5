#pragma once

#include "diagnosis/refit/folds.h"
#include "diagnosis/refit/refit.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lacuna {

/// A refitted model beside which forces are looked for. Everything referred to must live during the call.
struct ForceTask {
  const Refit& base;
  const std::vector<Eigen::MatrixXd>& factors;  ///< of the noise, by segment
  const Folds& folds;
  std::uint64_t seed = 1;
};

}  // namespace lacuna
