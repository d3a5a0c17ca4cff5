#include "effects/held_delay.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

EffectDescription HeldDelay::describe() const {
  return {.summary = "A pure delay of the command",
          .equation = "u_out(t) = u(t - delay)",
          .literature = "test only",
          .regime = "fast changes of the command",
          .look_alikes = {},
          .placements = {ElementKind::actuator},
          .parameters = {{"delay", "s", 0.0, 0.0, 0.1, Scale::linear, "Delay"}}};
}

int HeldDelay::state_size(const EffectContext& context) const {
  const int ring = static_cast<int>(std::ceil(context.parameters[0] / context.step)) + 2;
  return static_cast<int>(context.elements.size()) * (1 + ring);
}

double HeldDelay::command(double value, int which, const StepView&, const EffectContext& context,
                          std::span<double> state) const {
  const std::size_t block = state.size() / context.elements.size();
  const std::span<double> own = state.subspan(static_cast<std::size_t>(which) * block, block);
  const std::span<double> ring = own.subspan(1);
  if (own[0] == 0.0) std::ranges::fill(ring, value);
  const auto now = static_cast<std::size_t>(own[0]);
  ring[now % ring.size()] = value;
  own[0] += 1.0;

  const double steps = context.parameters[0] / context.step;
  const double whole = std::floor(steps);
  const auto back = [&](double count) {
    return ring[(now + ring.size() - static_cast<std::size_t>(count) % ring.size()) % ring.size()];
  };
  return (1.0 - (steps - whole)) * back(whole) + (steps - whole) * back(whole + 1.0);
}

}  // namespace lacuna
