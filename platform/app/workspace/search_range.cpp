#include "app/workspace/search_range.h"

#include "app/terminal/short_number.h"
#include "foundation/address.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kWider = 10.0;

std::pair<double, double> around(double start, const FreeValue& free) {
  const double most = kWider * std::abs(start);
  const double least = free.scale == Scale::logarithmic ? std::abs(start) / kWider : -most;
  return {std::max(free.lower, short_number(least)), std::min(free.upper, short_number(most))};
}

}  // namespace

std::map<std::string, std::pair<double, double>> search_range(const EffectEntry& entry,
                                                              const ModelDefinition& extended) {
  std::map<std::string, std::pair<double, double>> ranges;
  for (const auto& [name, start] : entry.start)
    for (const FreeValue& free : extended.free) {
      if (free.address != effect_address(entry.id, name) || start == 0.0) continue;
      const std::pair<double, double> range = around(start, free);
      const bool narrower = range.first > free.lower || range.second < free.upper;
      if (narrower && range.first < range.second) ranges[name] = range;
    }
  return ranges;
}

}  // namespace lacuna
