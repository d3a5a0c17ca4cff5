#include "simulation/shared/delay_line.h"

#include <cmath>

namespace lacuna::simulation {
namespace {

constexpr double kWholeTolerance = 1e-9;  // steps: tolerance of k·h/h against k

}  // namespace

Delay make_delay(double seconds, const EngineSettings& settings) {
  const double step = settings.step / settings.substeps;
  double steps = seconds / step;
  if (settings.delay_rounding == DelayRounding::step) steps = std::round(seconds / settings.step) * settings.substeps;
  const double nearest = std::round(steps);
  if (std::abs(steps - nearest) < kWholeTolerance * std::max(1.0, nearest))
    return {static_cast<std::size_t>(nearest), 0.0};
  return {static_cast<std::size_t>(steps), steps - std::floor(steps)};
}

void DelayLine::save(StateWriter& writer) const {
  for (std::size_t i = values_.size(); i-- > 0;) writer.put(values_[back(i)]);
}

void DelayLine::load(StateReader& reader) {
  for (double& value : values_) value = reader.get();
  newest_ = values_.empty() ? 0 : values_.size() - 1;
}

}  // namespace lacuna::simulation
