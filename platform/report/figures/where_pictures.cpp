#include "report/figures/where_pictures.h"

#include "foundation/text/unit_text.h"
#include "report/figures/figure.h"
#include "report/text/where_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kPanels = 12, kColumns = 3;
constexpr Eigen::Index kPoints = 1200;  // of a scatter; more hide each other

std::string view_name(const ResidualView& view) {
  return view.kind == ViewKind::acceleration ? "residual acceleration" : "free runs";
}

std::string ending(const ResidualView& view) {
  return view.kind == ViewKind::acceleration ? "-acceleration.svg" : ".svg";
}

/// Channel indices, the largest share of error first.
std::vector<std::size_t> drawn_channels(const ResidualView& view) {
  std::vector<std::size_t> order(view.channels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return view.channels[a].share_of_error > view.channels[b].share_of_error;
  });
  order.resize(std::min(order.size(), kDrawnChannels));
  return order;
}

/// Label of a bar.
struct Part {
  std::string name;
  double error = 0.0, samples = 0.0;
};

/// Without a tree: bins of the feature that the channel with most error depends on most.
std::vector<Part> parts_by_feature(const ResidualView& view, const FeatureTable& table) {
  if (view.channels.empty() || table.features.empty()) return {};
  const std::size_t channel = drawn_channels(view).front();
  const std::vector<IndependenceTest>& tests = view.channels[channel].features;
  const auto best =
      std::max_element(tests.begin(), tests.end(), [](const auto& a, const auto& b) { return a.share < b.share; });
  const auto feature = static_cast<std::size_t>(best - tests.begin());
  const Eigen::VectorXd values = table.values.col(static_cast<Eigen::Index>(feature));
  const Eigen::ArrayXd squares = view.residuals.col(static_cast<Eigen::Index>(channel)).array().square();
  const double all = squares.isFinite().select(squares, 0.0).sum(),
               count = static_cast<double>(squares.isFinite().count());
  std::vector<Part> parts;
  for (const ResidualBin& bin : best->bins) {
    const Eigen::Array<bool, Eigen::Dynamic, 1> inside =
        values.array() >= bin.lower && values.array() <= bin.upper && squares.isFinite();
    const double above = table.features[feature].classes() ? 0.5 : 0.0;
    parts.push_back({conditions_text({{feature, bin.lower, bin.upper + above}}, table),
                     inside.select(squares, 0.0).sum() / all, static_cast<double>(inside.count()) / count});
  }
  return parts;
}

std::optional<Figure> regimes_figure(const ResidualView& view, const FeatureTable& table, const std::string& title) {
  std::vector<Part> parts;
  for (const Regime& regime : view.regimes)
    parts.push_back({conditions_text(regime.conditions, table), regime.share_of_error, regime.share_of_samples});
  if (parts.empty()) parts = parts_by_feature(view, table);
  if (parts.empty()) return std::nullopt;
  constexpr double kHeight = 0.36;
  Series error{"of squared error", Mark::bars, kOrange, {}, {}, {}},
      samples{"of samples", Mark::bars, kGrey, {}, {}, {}};
  Panel panel{"", {}, 1.0, {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto at = static_cast<double>(i);
    error.x.push_back(100.0 * parts[i].error);
    error.y.push_back(at - 0.5 * kHeight);
    samples.x.push_back(100.0 * parts[i].samples);
    samples.y.push_back(at + 0.5 * kHeight);
    panel.y_names.push_back(parts[i].name);
  }
  error.y2.assign(parts.size(), kHeight);
  samples.y2.assign(parts.size(), kHeight);
  panel.series = {error, samples};
  Figure figure{title + " · " + view_name(view), "share [%]", {panel}};
  figure.height = 140 + 56 * static_cast<int>(parts.size());
  return figure;
}

std::string axis(const StateFeature& feature, const IndependenceTest& test, bool depends) {
  std::string text = feature.full_name();
  if (feature.unit != "1") text += " [" + unit_text(feature.unit) + "]";
  return text + (depends ? fmt::format(": depends, {:.0f} %", 100.0 * test.share) : "");
}

Panel feature_panel(const ResidualView& view, const FeatureTable& table, std::size_t channel, std::size_t feature) {
  const ChannelTests& tests = view.channels[channel];
  const IndependenceTest& test = tests.features[feature];
  Series points{"", Mark::points, kGrey, {}, {}, {}}, band{"", Mark::band, kOrange, {}, {}, {}};
  Series mean{"", Mark::line_points, kOrange, {}, {}, {}};
  const Eigen::Index stride = std::max<Eigen::Index>(1, view.residuals.rows() / kPoints);
  for (Eigen::Index row = 0; row < view.residuals.rows(); row += stride) {
    const double residual = test.shown.size() > 0 ? test.shown(row) : std::nan("");
    if (!std::isfinite(residual)) continue;
    points.x.push_back(table.values(row, static_cast<Eigen::Index>(feature)));
    points.y.push_back(residual);
  }
  for (const ResidualBin& bin : test.bins) {
    mean.x.push_back(bin.feature);
    mean.y.push_back(bin.mean);
    band.x.push_back(bin.feature);
    band.y.push_back(bin.mean - bin.band);
    band.y2.push_back(bin.mean + bin.band);
  }
  if (table.features[feature].classes()) band.mark = Mark::whiskers;
  Panel panel{
      (view.kind == ViewKind::acceleration ? "unexplained [" : "residual [") + tests.unit + "]", {points}, 1.0, {}};
  if (!test.bins.empty()) {
    panel.series.push_back(band);
    panel.series.push_back(mean);
  }
  panel.series.push_back({"", Mark::level, kInk, {}, {0.0}, {}});
  panel.x_label = axis(table.features[feature], test, view.depends(channel, feature));
  return panel;
}

Figure features_figure(const ResidualView& view, const FeatureTable& table, std::size_t channel,
                       const std::string& title) {
  const std::vector<IndependenceTest>& tests = view.channels[channel].features;
  std::vector<std::size_t> order(tests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tests[a].share > tests[b].share; });
  order.resize(std::min(order.size(), kPanels));
  Figure figure{
      fmt::format("{} · {} · {}: means with 99 % bands", title, view.channels[channel].channel, view_name(view)),
      "",
      {}};
  for (const std::size_t feature : order) figure.panels.push_back(feature_panel(view, table, channel, feature));
  figure.columns = static_cast<int>(kColumns);
  figure.height = 60 + 230 * static_cast<int>((order.size() + kColumns - 1) / kColumns);
  return figure;
}

Figure autocorrelation_figure(const ChannelWhiteness& whiteness, const std::string& title) {
  const Autocorrelation& one = whiteness.autocorrelation;
  const Series band{"99 % of white noise",  Mark::band,          kGrey, {0.0, one.lags.back()},
                    {-one.band, -one.band}, {one.band, one.band}};
  const Series curve{"residual of free runs", Mark::line_points, kOrange, one.lags, one.values, {}};
  Figure figure{title + " · " + whiteness.channel, "lag [s]", {{"autocorrelation", {band, curve}, 1.0, {}}}};
  figure.height = 400;
  return figure;
}

}  // namespace

std::vector<std::filesystem::path> draw_where(const WhereItFails& where, const std::string& title,
                                              const std::filesystem::path& folder, FileNames& names, const Stop& stop) {
  std::vector<std::filesystem::path> files;
  const auto draw = [&](const Figure& figure, const std::string& name) {
    files.push_back(folder / names.next(name));
    write_svg(figure, files.back(), stop);
  };
  for (const ResidualView& view : where.views) {
    if (const auto figure = regimes_figure(view, where.table, title)) draw(*figure, "where-regimes" + ending(view));
    for (const std::size_t channel : drawn_channels(view))
      if (!where.table.features.empty())
        draw(features_figure(view, where.table, channel, title),
             "where-" + view.channels[channel].channel + ending(view));
  }
  if (where.views.empty()) return files;
  for (const std::size_t channel : drawn_channels(where.views.front()))
    for (const ChannelWhiteness& one : where.whiteness)
      if (one.channel == where.views.front().channels[channel].channel && !one.autocorrelation.lags.empty())
        draw(autocorrelation_figure(one, title), "autocorrelation-" + one.channel + ".svg");
  return files;
}

}  // namespace lacuna
