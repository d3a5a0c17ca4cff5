#include "eea/eea_run.h"

#include "foundation/interrupt.h"

namespace lacuna {

void EeaRun::end_generation(const EeaState& state, const EeaProgress& now) const {
  if (progress) progress(now);
  journal.checkpoint(state, interrupt_requested());
  throw_if_interrupted();
}

}  // namespace lacuna
