#include "diagnosis/rounds/segment_lengths.h"
#include "foundation/unit.h"

#include <lacuna/physical_effect.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lacuna {
namespace {

constexpr double kSameSize = 1.5;  ///< times as large

/// A value at which a parameter has no size: where the effect does nothing, or 0 for one that does nothing where it is
/// beyond all limits, such as a stiffness. Nothing for a shape, which does nothing by itself.
std::optional<double> neutral_of(const EffectDescription& description, const std::string& parameter) {
  const bool has_size = std::any_of(description.parameters.begin(), description.parameters.end(),
                                    [](const ParameterDeclaration& one) { return one.scale == Scale::linear; });
  for (std::size_t i = 0; i < description.parameters.size(); ++i) {
    const ParameterDeclaration& one = description.parameters[i];
    if (one.name != parameter) continue;
    const double neutral = description.neutral.empty() ? one.default_value : description.neutral[i];
    if (one.scale == Scale::linear) return neutral;
    if (neutral != one.default_value) return 0.0;
    return has_size ? std::nullopt : std::optional(neutral);
  }
  return std::nullopt;
}

bool has_interval(const FoundParameter& one) { return std::isfinite(one.lower_95) && std::isfinite(one.upper_95); }

bool overlap(const FoundParameter& one, const FoundParameter& other) {
  return has_interval(one) && has_interval(other) && one.lower_95 <= other.upper_95 && other.lower_95 <= one.upper_95;
}

bool is_of_size(const FoundParameter& one, const FoundParameter& other, double neutral) {
  const double ratio = (other.value - neutral) / (one.value - neutral);
  return ratio > 1.0 / kSameSize && ratio < kSameSize;
}

/// Told apart from its neutral value.
bool is_told(const FoundParameter& one, double neutral) {
  return has_interval(one) && (one.lower_95 > neutral || one.upper_95 < neutral);
}

/// Whether the segments of that length speak no more against the answer's values than noise would in 19 of 20 (χ² by
/// E. B. Wilson and M. M. Hilferty, PNAS 17 (1931) 684-688).
bool allows(const EffectsAtLength& at) {
  std::size_t parameters = 0;
  for (const FoundEffect& effect : at.effects) parameters += effect.parameters.size();
  constexpr double kOneSided95 = 1.645;
  const double part = 2.0 / (9.0 * static_cast<double>(std::max<std::size_t>(parameters, 1)));
  return at.against <= static_cast<double>(parameters) * std::pow(1.0 - part + kOneSided95 * std::sqrt(part), 3);
}

const FoundParameter& same(const EffectsAtLength& at, std::size_t effect, std::size_t parameter) {
  return at.effects[effect].parameters[parameter];
}

std::string at_length(double value, double length) { return fmt::format("{:.3g} at {:.3g} s", value, length); }

}  // namespace

LengthVerdict judge_lengths(const std::vector<FoundEffect>& found, double segment,
                            const std::vector<EffectsAtLength>& others, const PluginCatalog& catalog) {
  LengthVerdict verdict;
  for (std::size_t e = 0; e < found.size() && !others.empty(); ++e) {
    const EffectDescription description = catalog.get<PhysicalEffect>(found[e].effect).describe();
    std::vector<std::string> values;
    bool survives = true, same_size = true;
    for (std::size_t p = 0; p < found[e].parameters.size(); ++p) {
      const FoundParameter& one = found[e].parameters[p];
      const std::optional<double> neutral = neutral_of(description, one.name);
      if (!neutral || !is_told(one, *neutral)) continue;
      std::vector<std::pair<double, double>> by_length = {{segment, one.value}};
      for (const EffectsAtLength& at : others) {
        by_length.emplace_back(at.segment, same(at, e, p).value);
        const FoundParameter& other = same(at, e, p);
        same_size = same_size && is_of_size(one, other, *neutral);
        survives = survives && (is_of_size(one, other, *neutral) || overlap(one, other) || allows(at));
      }
      std::sort(by_length.begin(), by_length.end());
      std::vector<std::string> texts;
      for (const auto& [length, value] : by_length) texts.push_back(at_length(value, length));
      values.push_back(
          fmt::format("{} {}{}", one.name, fmt::join(texts, ", "), one.unit == "1" ? "" : " (" + one.unit + ")"));
    }
    if (values.empty()) continue;
    verdict.survives = verdict.survives && survives;
    verdict.findings.push_back(fmt::format(
        "over segments of other lengths, {} @ {}: {}: {}", found[e].effect, found[e].where, fmt::join(values, "; "),
        !survives   ? "sign or size does not survive, so that it stands for something else at least in part"
        : same_size ? "sign and size survive"
                    : "they agree within what is uncertain of them"));
  }
  return verdict;
}

}  // namespace lacuna
