#include "answer/held_out_finding.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {

std::string held_out_finding(const std::vector<HorizonError>& errors) {
  double base = 0.0, answer = 0.0;
  int count = 0;
  for (const HorizonError& one : errors) {
    const double before = one.base_held_out / one.floor, after = one.answer_held_out / one.floor;
    if (!std::isfinite(before) || !std::isfinite(after)) continue;
    base += before * before;
    answer += after * after;
    ++count;
  }
  if (count == 0 || answer < base) return "";
  return fmt::format(
      "held-out recordings do not confirm the answer: their prediction error is {:.3g} × floor without it and {:.3g} × "
      "floor with it. The fit files may lack the motion that these recordings have; fit some of them too, hold out "
      "others, and diagnose again before you add the answer",
      std::sqrt(base / count), std::sqrt(answer / count));
}

}  // namespace lacuna
