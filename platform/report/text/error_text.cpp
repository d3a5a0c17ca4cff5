#include "report/text/error_text.h"

#include "foundation/text/counted.h"
#include "foundation/unit.h"

namespace lacuna {

std::string error_text(const PooledScore& score) {
  if (score.failed_trials > 0) return counted(static_cast<std::size_t>(score.failed_trials), "trial") + " failed";
  return format_quantity(score.rmse, score.unit);
}

}  // namespace lacuna
