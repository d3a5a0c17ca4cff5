#pragma once

#include "diagnosis/noise/base_solution.h"
#include "evaluation/model_definition.h"

#include <vector>

namespace lacuna {

/// How far the base's predictions can be trusted: by segment, bins × causes, in multiples of the sensor noise. The
/// model is simulated with shorter steps (and the change extrapolated to infinitely short ones, the engine being of
/// first order) and with contacts that yield a little more, and a little less, than its own: nobody knows these, yet
/// they decide when a foot lands. What that changes is what a right model may be wrong by. It is large where a sensor's
/// value hangs on the moment of an impact (to first order it is the derivative by that moment times the moment's
/// uncertainty), and where impacts have multiplied a small difference.
///
/// A cause that cannot be simulated is left out; without any, there is one column of zeros.
std::vector<Eigen::MatrixXd> contact_doubts(const ModelDefinition& definition, const BaseSolution& base,
                                            const RowBins& bins, int threads);

}  // namespace lacuna
