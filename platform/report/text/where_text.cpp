#include "report/text/where_text.h"

#include "foundation/text/counted.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kShown = 5;  // findings on a terminal; --json has all
constexpr std::size_t kNamed = 3;  // features in a sentence

std::string percent(double share) {
  const double value = 100.0 * share;
  return value > 0.0 && value < 0.95 ? fmt::format("{:.1g} %", value) : fmt::format("{:.0f} %", value);
}

std::string short_quantity(double value, const std::string& unit) { return format_quantity(value, unit, 2); }

std::string of_element(const StateFeature& feature) { return feature.of.empty() ? "" : " of " + feature.of; }

/// "12.3 to 14.5 s"; the bounds that there are.
std::string range_text(const Condition& condition, const std::string& unit, const char* below, const char* above) {
  if (std::isinf(condition.lower)) return fmt::format("{} {}", below, short_quantity(condition.upper, unit));
  if (std::isinf(condition.upper)) return fmt::format("{} {}", above, short_quantity(condition.lower, unit));
  return fmt::format("from {} to {}", short_quantity(condition.lower, unit), short_quantity(condition.upper, unit));
}

bool holds(const Condition& condition, double value) { return value >= condition.lower && value < condition.upper; }

std::string direction_text(const Condition& condition, const StateFeature& feature) {
  const std::string what = feature.of.empty() ? "" : feature.of + " ";
  const bool back = holds(condition, -1.0), rest = holds(condition, 0.0), forth = holds(condition, 1.0);
  if (back && forth) return what + "anywhere";
  if (!back && !forth) return what + "at rest";
  return what + (rest ? "at rest or " : "") + "moving in " + (forth ? "positive" : "negative") + " direction";
}

std::string contact_text(const Condition& condition, const StateFeature& feature) {
  return (feature.of.empty() ? "" : feature.of + " ") + (holds(condition, 1.0) ? "on the ground" : "off the ground");
}

std::string reversal_text(const Condition& condition, const StateFeature& feature) {
  const std::string after = " after a reversal" + of_element(feature);
  if (std::isinf(condition.lower)) return "within " + short_quantity(condition.upper, "s") + after;
  if (std::isinf(condition.upper)) return "more than " + short_quantity(condition.lower, "s") + after;
  return short_quantity(condition.lower, "s") + " to " + short_quantity(condition.upper, "s") + after;
}

std::string condition_text(const Condition& condition, const StateFeature& feature) {
  switch (feature.kind) {
    case FeatureKind::direction: return direction_text(condition, feature);
    case FeatureKind::contact: return contact_text(condition, feature);
    case FeatureKind::since_reversal: return reversal_text(condition, feature);
    case FeatureKind::time: return range_text(condition, "s", "before", "after");
    default: return feature.full_name() + " " + range_text(condition, feature.unit, "<", ">");
  }
}

/// Names of the features, none twice, `most` of them.
std::vector<std::string> names(const std::vector<std::size_t>& features, const FeatureTable& table, std::size_t most) {
  std::vector<std::string> all;
  for (const std::size_t feature : features) {
    const std::string name = table.features[feature].full_name();
    if (all.size() < most && std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
  }
  return all;
}

/// Kinds of features on which the residual does not depend; inputs first.
std::vector<std::string> independent_kinds(const Finding& finding, const FeatureTable& table) {
  constexpr FeatureKind kOrder[] = {FeatureKind::command,   FeatureKind::position, FeatureKind::velocity,
                                    FeatureKind::direction, FeatureKind::load,     FeatureKind::contact,
                                    FeatureKind::time};
  std::vector<std::string> kinds;
  for (const FeatureKind kind : kOrder) {
    std::string name;
    bool all = true;
    for (std::size_t f = 0; f < table.features.size(); ++f) {
      if (table.features[f].kind != kind) continue;
      name = table.features[f].name;
      all = all && std::find(finding.not_on.begin(), finding.not_on.end(), f) != finding.not_on.end();
    }
    if (all && !name.empty() && kinds.size() < kNamed) kinds.push_back(name);
  }
  return kinds;
}

/// "velocity, load and time".
std::string listed(const std::vector<std::string>& names, const char* last) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} {} {}", fmt::join(names.begin(), names.end() - 1, ", "), last, names.back());
}

std::string p_text(double p) { return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.2g}", p); }

std::string squares_text(const Finding& finding) {
  return percent(finding.share) +
         (finding.view == ViewKind::acceleration ? " of the squared residual acceleration" : " of the squared error");
}

std::string dependence_text(const Finding& finding, const FeatureTable& table) {
  std::string text = fmt::format("{} of {} depends on {} ({})", squares_text(finding), finding.channel,
                                 listed(names(finding.features, table, kNamed), "and"), p_text(finding.p));
  if (const std::vector<std::string> kinds = independent_kinds(finding, table); !kinds.empty())
    text += ", not on " + listed(kinds, "or");
  return text;
}

}  // namespace

std::string conditions_text(const std::vector<Condition>& conditions, const FeatureTable& table) {
  std::string text;
  for (const Condition& condition : conditions)
    text += (text.empty() ? "" : ", ") + condition_text(condition, table.features[condition.feature]);
  return text;
}

std::string finding_text(const Finding& finding, const FeatureTable& table) {
  const std::string share = squares_text(finding);
  switch (finding.kind) {
    case FindingKind::regime:
      return fmt::format("{} is in {} of the samples: {}", share, percent(finding.share_of_samples),
                         conditions_text(finding.conditions, table));
    case FindingKind::dependence: return dependence_text(finding, table);
    case FindingKind::offset:
      return fmt::format("{} is an offset: {} is measured {} {} than predicted on average", share, finding.channel,
                         short_quantity(std::abs(finding.size), finding.unit), finding.size > 0.0 ? "higher" : "lower");
    case FindingKind::magnitude:
      return fmt::format("{} is an error of amplitude: the predicted {} is {} too {}", share, finding.channel,
                         percent(std::abs(finding.size)), finding.size > 0.0 ? "large" : "small");
    case FindingKind::trial:
      return fmt::format("{} is in {}, which has {} of the samples", share, finding.trial,
                         percent(finding.share_of_samples));
  }
  return {};
}

std::string where_text(const WhereItFails& where) {
  if (where.views.empty()) return "";
  if (where.findings.empty())
    return fmt::format("where  no significant dependence on input or state (99 % level, {} tested)\n",
                       counted(where.table.features.size(), "feature"));
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, where.findings.size()); ++i)
    text += (text.empty() ? "where  " : "       ") + finding_text(where.findings[i], where.table) + "\n";
  return text;
}

}  // namespace lacuna
