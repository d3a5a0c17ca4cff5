#include "where_it_fails/residual_view.h"

#include "where_it_fails/feature_selection.h"
#include "where_it_fails/unexplained_acceleration.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kViews = 2;  // views that share the false alarms

/// At the rows of a table, a column a channel.
struct Rows {
  std::vector<Channel> channels;
  Eigen::MatrixXd residuals, floors;
  std::vector<Eigen::MatrixXd> covariates;  ///< one per channel: covariates (rows ×) of its residual
  Eigen::ArrayXXd squares() const { return (residuals.array() / floors.array()).square(); }
};

Rows free_run_rows(const Comparison& comparison, const FeatureTable& table) {
  const std::vector<Channel> channels = channels_of(comparison);
  const auto n = static_cast<Eigen::Index>(table.trial.size());
  const auto width = static_cast<Eigen::Index>(channels.size());
  Rows rows{channels, Eigen::MatrixXd::Constant(n, width, kNoValue), Eigen::MatrixXd::Constant(n, width, kNoValue),
            std::vector<Eigen::MatrixXd>(channels.size())};
  for (Eigen::Index row = 0; row < n; ++row) {
    const TrialComparison& trial = comparison.trials[table.trial[static_cast<std::size_t>(row)]];
    for (std::size_t c = 0; c < trial.channels.size(); ++c) {
      const ChannelScore& score = trial.channels[c];
      const auto found = std::find(channels.begin(), channels.end(), Channel{score.channel, score.unit});
      if (found == channels.end() || !(score.floor > 0.0)) continue;
      rows.residuals(row, found - channels.begin()) =
          trial.residuals(table.sample[static_cast<std::size_t>(row)], static_cast<Eigen::Index>(c));
      rows.floors(row, found - channels.begin()) = score.floor;
    }
  }
  return rows;
}

Rows acceleration_rows(const Accelerations& accelerations, Eigen::Index n) {
  const auto width = static_cast<Eigen::Index>(accelerations.channels.size());
  Rows rows{{}, Eigen::MatrixXd(n, width), Eigen::MatrixXd(n, width), {}};
  for (Eigen::Index c = 0; c < width; ++c) {
    const UnexplainedAcceleration& one = accelerations.channels[static_cast<std::size_t>(c)];
    rows.channels.push_back(one.channel);
    rows.residuals.col(c) = one.values;
    rows.floors.col(c) = one.deviations;
    rows.covariates.push_back(one.own_error);
  }
  return rows;
}

double finite_sum(const Eigen::ArrayXXd& values) { return values.isFinite().select(values, 0.0).sum(); }

double times_floor(const Eigen::ArrayXXd& squares) {
  return std::sqrt(finite_sum(squares) / static_cast<double>(squares.isFinite().count()));
}

/// Readings of a touch sensor are a feature themselves: that the residual depends on them shows nothing.
std::vector<std::size_t> own_features(const RobotSpec& robot, const Channel& channel, const FeatureTable& table) {
  std::vector<std::size_t> own;
  for (const SensorSpec& sensor : robot.sensors)
    for (std::size_t f = 0; f < table.features.size(); ++f) {
      const StateFeature& feature = table.features[f];
      if (sensor.kind == SensorKind::touch && sensor.name == channel.name && feature.kind == FeatureKind::contact &&
          (feature.of.empty() || feature.of == "body." + sensor.element))
        own.push_back(f);
    }
  return own;
}

std::vector<ChannelTests> tests_of(const RobotSpec& robot, const Rows& rows, const FeatureTable& table,
                                   std::size_t family, const Work& work) {
  std::vector<ChannelTests> all(rows.channels.size());
  for (std::size_t c = 0; c < all.size(); ++c) {
    all[c].channel = rows.channels[c].name;
    all[c].unit = rows.channels[c].unit;
    const Eigen::VectorXd residual = rows.residuals.col(static_cast<Eigen::Index>(c));
    select_features({residual, rows.covariates[c], table, family, own_features(robot, rows.channels[c], table), work},
                    all[c]);
  }
  return all;
}

std::vector<Condition> conditions_of(const RegressionTree& tree, int leaf) {
  std::vector<Condition> conditions;
  for (int node = leaf; tree.nodes[static_cast<std::size_t>(node)].parent >= 0;) {
    const int parent = tree.nodes[static_cast<std::size_t>(node)].parent;
    const RegressionTree::Node& asked = tree.nodes[static_cast<std::size_t>(parent)];
    const auto feature = static_cast<std::size_t>(asked.feature);
    auto found =
        std::find_if(conditions.begin(), conditions.end(), [&](const auto& one) { return one.feature == feature; });
    if (found == conditions.end()) found = conditions.insert(conditions.end(), Condition{feature});
    if (node == asked.left)
      found->upper = std::min(found->upper, asked.threshold);
    else
      found->lower = std::max(found->lower, asked.threshold);
    node = parent;
  }
  std::reverse(conditions.begin(), conditions.end());
  return conditions;
}

/// Grows the tree over the rows with a residual in some channel; `squares` are sums over channels.
void part(ResidualView& view, const FeatureTable& table, const Eigen::ArrayXXd& squares) {
  std::vector<Eigen::Index> scored;
  std::vector<double> sums;
  for (Eigen::Index row = 0; row < squares.rows(); ++row) {
    if (squares.row(row).isFinite().count() == 0) continue;
    scored.push_back(row);
    sums.push_back(finite_sum(squares.row(row)) / static_cast<double>(squares.row(row).isFinite().count()));
  }
  const Eigen::Map<const Eigen::VectorXd> error(sums.data(), static_cast<Eigen::Index>(sums.size()));
  const Eigen::MatrixXd features = table.values(scored, Eigen::all);
  view.tree = grow_tree(features, error);
  if (!view.tree.grown()) return;
  const double mean = error.mean();
  for (std::size_t node = 0; node < view.tree.nodes.size(); ++node) {
    const RegressionTree::Node& leaf = view.tree.nodes[node];
    if (leaf.left >= 0) continue;
    view.regimes.push_back({conditions_of(view.tree, static_cast<int>(node)), leaf.share_of_error,
                            leaf.share_of_samples, std::sqrt(mean * leaf.share_of_error / leaf.share_of_samples)});
  }
  std::stable_sort(view.regimes.begin(), view.regimes.end(),
                   [](const Regime& a, const Regime& b) { return a.share_of_error > b.share_of_error; });
}

ResidualView view_of(const RobotSpec& robot, Rows rows, const FeatureTable& table, const Work& work) {
  const Eigen::ArrayXXd squares = rows.squares();
  ResidualView view;
  view.times_floor = times_floor(squares);
  view.family = kViews * rows.channels.size() * table.features.size();
  view.channels = tests_of(robot, rows, table, view.family, work);
  const double all = finite_sum(squares);
  for (std::size_t c = 0; c < view.channels.size() && all > 0.0; ++c)
    view.channels[c].share_of_error = finite_sum(squares.col(static_cast<Eigen::Index>(c))) / all;
  part(view, table, squares);
  view.residuals = std::move(rows.residuals);
  return view;
}

}  // namespace

bool ResidualView::depends(std::size_t channel, std::size_t feature) const {
  const IndependenceTest& test = channels[channel].features[feature];
  return outside_band(test, family);
}

std::vector<Channel> channels_of(const Comparison& comparison) {
  std::vector<Channel> channels;
  for (const TrialComparison& trial : comparison.trials)
    for (const ChannelScore& score : trial.channels) {
      const Channel channel{score.channel, score.unit};
      if (!trial.held_out && std::find(channels.begin(), channels.end(), channel) == channels.end())
        channels.push_back(channel);
    }
  return channels;
}

ResidualView free_run_view(const RobotSpec& robot, const Comparison& comparison, const FeatureTable& table,
                           const Work& work) {
  return view_of(robot, free_run_rows(comparison, table), table, work);
}

ResidualView acceleration_view(const RobotSpec& robot, const Comparison& comparison, const FeatureTable& table,
                               const Work& work) {
  const Accelerations accelerations = unexplained_accelerations(robot, comparison, table);
  if (accelerations.channels.empty()) return {};
  ResidualView view = view_of(robot, acceleration_rows(accelerations, table.values.rows()), table, work);
  view.kind = ViewKind::acceleration;
  view.horizon = accelerations.horizon;
  return view;
}

}  // namespace lacuna
