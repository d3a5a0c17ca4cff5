#pragma once

#include <lacuna/error.h>
#include <lacuna/model_encoding.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace lacuna {

/// Functions shared by encodings with one gene per free parameter. The gene is the value in SI, also for logarithmic
/// parameters, so that a stored genome is readable.

/// One real gene per free parameter, in their order, named by its address. Throws `Error` for a parameter without
/// finite bounds.
inline void append_value_genes(std::span<const FreeParameter> free, std::vector<Gene>& genes) {
  for (const FreeParameter& parameter : free) {
    if (!std::isfinite(parameter.lower) || !std::isfinite(parameter.upper) || parameter.lower > parameter.upper)
      throw Error(parameter.address + " has no finite search range; give its bounds under [model.free]");
    genes.push_back({parameter.address, parameter.unit, GeneKind::real, parameter.lower, parameter.upper});
  }
}

/// The values of the same number of genes: clamped to the search bounds.
inline std::vector<double> values_of_genes(std::span<const FreeParameter> free, std::span<const double> genes) {
  std::vector<double> values(free.size());
  for (std::size_t i = 0; i < free.size(); ++i) values[i] = std::clamp(genes[i], free[i].lower, free[i].upper);
  return values;
}

}  // namespace lacuna
