#include "eea/eea_run.h"

namespace lacuna {

void EeaRun::end_generation(const EeaState& state, const EeaProgress& now) const {
  if (progress) progress(now);
  const bool is_last = work.stop.is_due();  // checked once: a later signal waits for the next generation
  journal.checkpoint(state, is_last);
  if (is_last) work.stop.throw_if_due();
}

}  // namespace lacuna
