#include "report/json/where_json.h"

#include "report/text/where_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

const char* name_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::regime: return "regime";
    case FindingKind::dependence: return "dependence";
    case FindingKind::offset: return "offset";
    case FindingKind::magnitude: return "magnitude";
    case FindingKind::trial: return "trial";
  }
  return "";
}

const char* name_of(ViewKind kind) { return kind == ViewKind::acceleration ? "acceleration" : "free_run"; }

ordered_json horizon_json(double horizon) { return horizon > 0.0 ? ordered_json(horizon) : ordered_json(nullptr); }

ordered_json document(const StateFeature& feature) {
  return {{"name", feature.name}, {"of", feature.of}, {"unit", feature.unit}};
}

ordered_json document(const std::vector<Condition>& conditions, const FeatureTable& table) {
  ordered_json all = ordered_json::array();
  for (const Condition& condition : conditions) {
    ordered_json one = document(table.features[condition.feature]);
    one["from"] = condition.lower;  // infinite: null
    one["below"] = condition.upper;
    all.push_back(std::move(one));
  }
  return all;
}

ordered_json names(const std::vector<std::size_t>& features, const FeatureTable& table) {
  ordered_json all = ordered_json::array();
  for (const std::size_t feature : features) all.push_back(table.features[feature].full_name());
  return all;
}

ordered_json document(const Finding& finding, const FeatureTable& table) {
  ordered_json one = {{"kind", name_of(finding.kind)},
                      {"share", finding.share},
                      {"sentence", finding_text(finding, table)},
                      {"view", name_of(finding.view)}};
  if (!finding.channel.empty()) one["channel"] = finding.channel;
  switch (finding.kind) {
    case FindingKind::regime:
      one["share_of_samples"] = finding.share_of_samples;
      one["conditions"] = document(finding.conditions, table);
      break;
    case FindingKind::dependence:
      one["depends_on"] = names(finding.features, table);
      one["not_on"] = names(finding.not_on, table);
      one["p"] = finding.p;
      break;
    case FindingKind::offset:
      one["offset"] = finding.size;
      one["unit"] = finding.unit;
      one["p"] = finding.p;
      break;
    case FindingKind::magnitude: one["relative"] = finding.size; break;
    case FindingKind::trial:
      one["trial"] = finding.trial;
      one["share_of_samples"] = finding.share_of_samples;
      break;
  }
  return one;
}

ordered_json document(const IndependenceTest& test, std::size_t family) {
  ordered_json bins = ordered_json::array();
  for (const ResidualBin& bin : test.bins)
    bins.push_back({{"from", bin.lower},
                    {"to", bin.upper},
                    {"feature", bin.feature},
                    {"mean", bin.mean},
                    {"band99", bin.band},
                    {"samples", bin.samples}});
  return {{"testable", test.testable},
          {"share", test.share},
          {"statistic", test.statistic},
          {"band99", test.critical},
          {"degrees_of_freedom", {test.numerator, test.denominator}},
          {"p", std::min(1.0, test.p * static_cast<double>(family))},
          {"bins", bins}};
}

ordered_json document(const RegressionTree& tree, const FeatureTable& table) {
  ordered_json nodes = ordered_json::array();
  for (const RegressionTree::Node& node : tree.nodes) {
    ordered_json one = {
        {"parent", node.parent}, {"share_of_error", node.share_of_error}, {"share_of_samples", node.share_of_samples}};
    if (node.feature >= 0) {
      one["feature"] = table.features[static_cast<std::size_t>(node.feature)].full_name();
      one["below"] = node.threshold;
      one["left"] = node.left;
      one["right"] = node.right;
      one["gain_nats"] = node.gain;
      one["p"] = node.p;
    }
    nodes.push_back(std::move(one));
  }
  return nodes;
}

ordered_json document(const ResidualView& view, const FeatureTable& table) {
  ordered_json channels = ordered_json::array(), regimes = ordered_json::array();
  for (std::size_t c = 0; c < view.channels.size(); ++c) {
    const ChannelTests& tests = view.channels[c];
    ordered_json independence = ordered_json::array(), selected = ordered_json::array();
    for (std::size_t f = 0; f < tests.features.size(); ++f) {
      ordered_json one = document(table.features[f]);
      one.update(document(tests.features[f], view.family));
      one["depends"] = view.depends(c, f);
      independence.push_back(std::move(one));
    }
    for (const ChannelTests::Selected& one : tests.selected)
      selected.push_back({{"feature", table.features[one.feature].full_name()}, {"share", one.share}, {"p", one.p}});
    channels.push_back({{"channel", tests.channel},
                        {"unit", tests.unit},
                        {"share_of_error", tests.share_of_error},
                        {"mean", document(tests.mean, view.channels.size())},
                        {"independence", independence},
                        {"selected", selected},
                        {"not_on", names(tests.not_on, table)}});
  }
  for (const Regime& regime : view.regimes)
    regimes.push_back({{"sentence", conditions_text(regime.conditions, table)},
                       {"share_of_error", regime.share_of_error},
                       {"share_of_samples", regime.share_of_samples},
                       {"times_floor", regime.times_floor},
                       {"conditions", document(regime.conditions, table)}});
  return {{"view", name_of(view.kind)}, {"horizon_s", horizon_json(view.horizon)}, {"times_floor", view.times_floor},
          {"channels", channels},       {"tree", document(view.tree, table)},      {"regimes", regimes}};
}

ordered_json document(const ChannelWhiteness& whiteness) {
  const Autocorrelation& one = whiteness.autocorrelation;
  return {{"channel", whiteness.channel},       {"lags_s", one.lags},
          {"autocorrelation", one.values},      {"band99", one.band},
          {"share_outside", one.share_outside}, {"ljung_box", one.statistic},
          {"degrees_of_freedom", one.freedom},  {"p", one.p}};
}

bool holds(const std::vector<Condition>& conditions, const FeatureTable& table, Eigen::Index row) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& one) {
    const double value = table.values(row, static_cast<Eigen::Index>(one.feature));
    return value >= one.lower && value < one.upper;
  });
}

/// Where the conditions hold: trials with [from, to] in s. A row of the table stands for the time until the next one.
ordered_json stretches(const std::vector<Condition>& conditions, const FeatureTable& table,
                       const Comparison& comparison) {
  ordered_json all = ordered_json::array();
  std::optional<std::size_t> trial;
  bool inside = false;
  for (std::size_t row = 0; row < table.trial.size(); ++row) {
    const TrialComparison& of = comparison.trials[table.trial[row]];
    const bool last = row + 1 == table.trial.size() || table.trial[row + 1] != table.trial[row];
    const bool here = holds(conditions, table, static_cast<Eigen::Index>(row));
    const double begin = of.times[table.sample[row]], end = last ? begin : of.times[table.sample[row + 1]];
    if (here && trial != table.trial[row]) {
      trial = table.trial[row];
      all.push_back({{"trial", of.trial}, {"spans", ordered_json::array()}});
      inside = false;
    }
    if (here && !inside) all.back()["spans"].push_back({begin, end});
    if (here) all.back()["spans"].back()[1] = end;
    inside = here && !last;
  }
  return all;
}

/// The whole of a trial that has more than its part.
ordered_json whole_trial(const std::string& name, const Comparison& comparison) {
  ordered_json all = ordered_json::array();
  for (const TrialComparison& trial : comparison.trials)
    if (trial.trial == name && trial.times.size() > 0)
      all.push_back({{"trial", name}, {"spans", {{trial.times[0], trial.times[trial.times.size() - 1]}}}});
  return all;
}

}  // namespace

ordered_json findings_json(const WhereItFails& where) {
  ordered_json findings = ordered_json::array();
  for (const Finding& finding : where.findings) findings.push_back(document(finding, where.table));
  return findings;
}

ordered_json where_json(const WhereItFails& where) {
  ordered_json features = ordered_json::array(), views = ordered_json::array(), whiteness = ordered_json::array();
  for (const StateFeature& feature : where.table.features) features.push_back(document(feature));
  for (const ResidualView& view : where.views) views.push_back(document(view, where.table));
  for (const ChannelWhiteness& one : where.whiteness) whiteness.push_back(document(one));
  return {{"samples", where.table.trial.size()}, {"features", features}, {"whiteness", whiteness}, {"views", views}};
}

std::string where_document(const WhereItFails& where, const Comparison& comparison, const Advice& advice) {
  ordered_json findings = findings_json(where), details = where_json(where);
  for (std::size_t i = 0; i < where.findings.size(); ++i) {
    const Finding& finding = where.findings[i];
    if (finding.kind == FindingKind::regime)
      findings[i]["stretches"] = stretches(finding.conditions, where.table, comparison);
    if (finding.kind == FindingKind::trial) findings[i]["stretches"] = whole_trial(finding.trial, comparison);
  }
  for (std::size_t v = 0; v < where.views.size(); ++v)
    for (std::size_t r = 0; r < where.views[v].regimes.size(); ++r)
      details["views"][v]["regimes"][r]["stretches"] =
          stretches(where.views[v].regimes[r].conditions, where.table, comparison);
  const ordered_json follows = {
      {"result", advice.result}, {"next", advice.next}, {"is_explained", advice.is_explained}};
  return ordered_json{{"findings", findings}, {"where", details}, {"advice", follows}}.dump();
}

}  // namespace lacuna
