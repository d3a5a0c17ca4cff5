#include "fitting/shooting/residual_memory.h"

#include "fitting/numerics/correlation_time.h"

#include <algorithm>
#include <map>
#include <utility>

namespace lacuna {
namespace {

/// Residuals of one trial and channel in the order of time.
struct Trace {
  std::vector<double> values;
  double first = 0.0, last = 0.0;
  double interval() const { return values.size() > 1 ? (last - first) / static_cast<double>(values.size() - 1) : 0.0; }
};

}  // namespace

ResidualMemory residual_memory(const ShootingProblem& problem, const std::vector<Eigen::VectorXd>& residuals) {
  std::map<std::pair<std::size_t, std::size_t>, Trace> traces;
  for (std::size_t k = 0; k < residuals.size(); ++k)
    for (Eigen::Index row = 0; row < problem.robust_rows(k); ++row) {
      const ResidualPlace place = problem.place(k, row);
      Trace& trace = traces[{place.trial, place.channel}];
      if (trace.values.empty()) trace.first = place.time;
      trace.last = place.time;
      trace.values.push_back(residuals[k](row));
    }
  ResidualMemory memory{0.0, 0.0};
  for (const auto& [where, trace] : traces) {
    const double together = correlation_samples(trace.values);
    memory.time = std::max(memory.time, trace.interval() * together);
    memory.effective_samples += static_cast<double>(trace.values.size()) / together;
  }
  memory.effective_samples = std::max(memory.effective_samples, 1.0);
  return memory;
}

}  // namespace lacuna
