#include "eea/eea_run.h"

#include "foundation/processes/interrupt.h"

namespace lacuna {

void EeaRun::end_generation(const EeaState& state, const EeaProgress& now) const {
  if (progress) progress(now);
  const bool stop = interrupt_requested();  // checked once: a later signal waits for the next generation
  journal.checkpoint(state, stop);
  if (stop) throw_if_interrupted();
}

}  // namespace lacuna
