#include "answer/doubted_data.h"

#include <limits>

namespace lacuna {

void add_doubts(const std::vector<DataWarning>& doubts, Diagnosis& result) {
  std::size_t faults = result.stopped ? 1 : 0;  // the sentence about a stopped search stays first
  for (const DataWarning& doubt : doubts) {
    const bool is_fault = doubt.severity == Severity::fault;
    const auto end = result.findings.end();
    result.findings.insert(is_fault ? result.findings.begin() + static_cast<std::ptrdiff_t>(faults++) : end,
                           doubt.sentence);
    if (!is_fault) continue;
    if (result.verdict == Verdict::nothing_missing || doubt.voids) result.verdict = Verdict::cannot_tell;
    if (doubt.voids) result.formulas.clear();
    result.probability = std::numeric_limits<double>::quiet_NaN();
    result.calibrated = false;
  }
}

}  // namespace lacuna
