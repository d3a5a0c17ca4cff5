#pragma once

#include "fitting/fit.h"

#include <string>
#include <vector>

namespace lacuna {

/// Whether any value changed by more than a fifth of its size.
bool moved(const std::vector<double>& before, const std::vector<double>& after);

/// One sentence for each value that differs between short segments and the last stage: by more than twice its 95 %
/// interval and a fifth of its size, or by a fifth where it ended at a bound; not for a value that short segments leave
/// at an end of its range in `free` other than 0, because they do not determine it. A right model's values do not
/// depend on the length of segments (METHOD's step 4); a dependence shows that the model lacks something slow.
std::vector<std::string> drift_sentences(const std::vector<FitStage>& stages, const std::vector<FittedValue>& values,
                                         const std::vector<FreeValue>& free);

}  // namespace lacuna
