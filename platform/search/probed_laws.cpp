#include "search/probed_laws.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kLeastSize = 1e-6;
constexpr std::array kPartsOfAFactor = {0.25, 0.1};  ///< of what it promises to first order, which ends soon

/// Whether a probe was sized by a number that multiplies, and that changes nothing within its range.
bool is_factor(const Hypothesis& hypothesis, const SizedProbe& probe) {
  if (!probe.sized) return false;
  const FreeValue& free = hypothesis.definition.free[hypothesis.own[*probe.sized]];
  const double neutral = hypothesis.neutral[*probe.sized];
  return free.scale == Scale::logarithmic && neutral > free.lower && neutral < free.upper;
}

/// The parameter by which a probe was sized, moved to a multiple of its distance from its neutral value. A factor is
/// multiplied or divided. A parameter that is neutral at an end of its range acts in proportion to it, or to its
/// reciprocal: a stiff spring changes little.
double value_at_size(const Hypothesis& hypothesis, const SizedProbe& probe, double size) {
  const std::size_t i = *probe.sized;
  const FreeValue& free = hypothesis.definition.free[hypothesis.own[i]];
  const double neutral = hypothesis.neutral[i], probed = probe.own[i];
  const double value = free.scale == Scale::linear    ? neutral + size * (probed - neutral)
                       : is_factor(hypothesis, probe) ? neutral * std::pow(probed / neutral, size)
                       : probed < neutral             ? probed / std::max(size, kLeastSize)
                                                      : probed * size;
  return std::clamp(value, free.lower, free.upper);
}

/// Whether two probes can be added to first order: the same law, each sized by another linear parameter.
bool act_together(const Hypothesis& hypothesis, const SizedProbe& one, const SizedProbe& other) {
  if (!one.sized || !other.sized || *one.sized == *other.sized) return false;
  for (std::size_t i = 0; i < one.own.size(); ++i) {
    const bool is_sized = i == *one.sized || i == *other.sized;
    if (is_sized && hypothesis.definition.free[hypothesis.own[i]].scale != Scale::linear) return false;
    if (!is_sized && one.own[i] != other.own[i]) return false;
  }
  return one.own[*other.sized] == hypothesis.neutral[*other.sized] &&
         other.own[*one.sized] == hypothesis.neutral[*one.sized];
}

}  // namespace

std::vector<std::vector<double>> starting_values(const Hypothesis& hypothesis, const std::vector<SizedProbe>& probes,
                                                 const Eigen::VectorXd& sizes) {
  const Eigen::VectorXd between = sizes.cwiseSign().cwiseProduct(sizes.cwiseAbs().cwiseSqrt());
  std::vector<std::vector<double>> starts = {values_at_sizes(hypothesis, probes, sizes),
                                             values_at_sizes(hypothesis, probes, between), probes.front().own};
  if (std::any_of(probes.begin(), probes.end(), [&](const SizedProbe& probe) { return is_factor(hypothesis, probe); }))
    for (const double part : kPartsOfAFactor) starts.push_back(values_at_sizes(hypothesis, probes, part * sizes));
  return starts;
}

std::vector<double> values_at_sizes(const Hypothesis& hypothesis, const std::vector<SizedProbe>& probes,
                                    const Eigen::VectorXd& sizes) {
  std::vector<double> own = probes.front().own;
  for (const SizedProbe& probe : probes)
    for (std::size_t i = 0; i < own.size(); ++i)
      if (probe.own[i] != hypothesis.neutral[i]) own[i] = probe.own[i];
  for (std::size_t p = 0; p < probes.size(); ++p)
    if (probes[p].sized)
      own[*probes[p].sized] = value_at_size(hypothesis, probes[p], sizes(static_cast<Eigen::Index>(p)));
  return own;
}

std::vector<std::vector<std::size_t>> laws_of(const Hypothesis& hypothesis,
                                              const std::vector<ProbeResponse>& responses) {
  std::vector<std::vector<std::size_t>> laws;
  std::vector<char> is_taken(responses.size(), 0);
  for (std::size_t r = 0; r < responses.size(); ++r) {
    if (is_taken[r]) continue;
    std::vector<std::size_t> law = {r};
    for (std::size_t o = r + 1; o < responses.size(); ++o) {
      const SizedProbe& other = responses[o].probe;
      if (other.own == responses[r].probe.own && other.sized == responses[r].probe.sized) is_taken[o] = 1;
      const bool fits = std::all_of(law.begin(), law.end(), [&](std::size_t member) {
        return act_together(hypothesis, responses[member].probe, other);
      });
      if (!is_taken[o] && fits) law.push_back(o);
    }
    for (const std::size_t member : law) is_taken[member] = 1;
    laws.push_back(std::move(law));
  }
  return laws;
}

}  // namespace lacuna
