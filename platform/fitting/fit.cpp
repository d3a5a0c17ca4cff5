#include "fitting/fit.h"

#include "fitting/comparison.h"

namespace lacuna {

std::vector<double> FitResult::parameters() const {
  std::vector<double> all;
  for (const FittedValue& value : values) all.push_back(value.value);
  return all;
}

FitResult as_written(const ModelDefinition& definition) {
  FitResult result;
  for (const FreeValue& free : definition.free) {
    FittedValue value;
    value.address = free.address;
    value.unit = free.unit;
    value.start = value.value = free.start;
    value.standard_error = value.lower_95 = value.upper_95 = std::numeric_limits<double>::quiet_NaN();
    result.values.push_back(value);
  }
  return result;
}

}  // namespace lacuna
