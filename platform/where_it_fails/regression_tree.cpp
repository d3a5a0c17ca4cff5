#include "where_it_fails/regression_tree.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kCuts = 64;
constexpr int kTreeFolds = 10;
constexpr Eigen::Index kBlocks = 20;

/// Samples and their error.
struct Mass {
  double samples = 0.0, error = 0.0;
  Mass& operator+=(const Mass& other) {
    samples += other.samples;
    error += other.error;
    return *this;
  }
  Mass operator-(const Mass& other) const { return {samples - other.samples, error - other.error}; }
};

/// A column in classes of similar values, each with about as many samples.
struct BinnedColumn {
  std::vector<double> edges;  ///< between classes, ascending
  std::vector<std::uint8_t> bin;
};

BinnedColumn binned(const Eigen::VectorXd& column) {
  std::vector<double> sorted(column.begin(), column.end());
  std::sort(sorted.begin(), sorted.end());
  BinnedColumn result;
  for (std::size_t k = 1; k < kCuts; ++k) {
    const std::size_t at = k * sorted.size() / kCuts;
    if (at == 0) continue;
    // Between two values, so that equal ones stay together.
    const auto first = std::lower_bound(sorted.begin(), sorted.end(), sorted[at]);
    if (first == sorted.begin()) continue;
    const double edge = 0.5 * (*first + *(first - 1));
    if (result.edges.empty() || edge > result.edges.back()) result.edges.push_back(edge);
  }
  for (const double value : column)
    result.bin.push_back(static_cast<std::uint8_t>(std::upper_bound(result.edges.begin(), result.edges.end(), value) -
                                                   result.edges.begin()));
  return result;
}

/// Σ error · log(error/samples); the gain of a split is the difference of this sum.
double information(const Mass& mass) {
  return mass.error > 0.0 ? mass.error * std::log(mass.error / mass.samples) : 0.0;
}

struct Split {
  std::size_t feature = 0;
  std::size_t edge = 0;  ///< classes up to this one go left
  Mass left, whole;
  double gain = 0.0;
};

/// Samples and errors of a node, by feature, class and fold.
class Histograms {
 public:
  using Folds = std::array<Mass, kTreeFolds>;

  Histograms(const std::vector<BinnedColumn>& columns, const Eigen::VectorXd& error,
             const std::vector<Eigen::Index>& rows, const std::vector<int>& folds)
      : columns_(columns) {
    for (const BinnedColumn& column : columns) {
      std::vector<Folds> classes(column.edges.size() + 1);
      for (const Eigen::Index row : rows) {
        const auto r = static_cast<std::size_t>(row);
        classes[column.bin[r]][static_cast<std::size_t>(folds[r])] += {1.0, error(row)};
      }
      classes_.push_back(std::move(classes));
    }
  }

  /// The best split found without the samples of fold `without`; none: with all samples.
  std::optional<Split> best(std::optional<int> without, double least_samples) const {
    std::optional<Split> best;
    for (std::size_t f = 0; f < classes_.size(); ++f) {
      Mass whole;
      for (const Folds& one : classes_[f]) whole += counted(one, without);
      Mass left;
      for (std::size_t edge = 0; edge + 1 < classes_[f].size(); ++edge) {
        left += counted(classes_[f][edge], without);
        const Mass right = whole - left;
        if (left.samples < least_samples || right.samples < least_samples) continue;
        const double gain = information(left) + information(right) - information(whole);
        if (!best || gain > best->gain) best = Split{f, edge, left, whole, gain};
      }
    }
    return best;
  }

  /// The gain of the split's rates over a single rate, on the errors of this fold.
  double gain_on(int fold, const Split& split) const {
    Mass left, whole;
    const std::vector<Folds>& classes = classes_[split.feature];
    for (std::size_t i = 0; i < classes.size(); ++i) {
      const Mass& mass = classes[i][static_cast<std::size_t>(fold)];
      whole += mass;
      if (i <= split.edge) left += mass;
    }
    const double rate = split.whole.error / split.whole.samples;
    return told(left, split.left, rate) + told(whole - left, split.whole - split.left, rate);
  }

  double threshold(const Split& split) const { return columns_[split.feature].edges[split.edge]; }

 private:
  static Mass counted(const Folds& folds, std::optional<int> without) {
    Mass mass;
    for (int fold = 0; fold < kTreeFolds; ++fold)
      if (fold != without) mass += folds[static_cast<std::size_t>(fold)];
    return mass;
  }
  static double told(const Mass& seen, const Mass& learnt, double rate) {
    constexpr double kLeastRatio = 1e-3;  // a part without error in the training folds may have some in this one
    const double ratio = std::max(learnt.error / (learnt.samples * rate), kLeastRatio);
    return seen.error * std::log(ratio) - seen.samples * rate * (ratio - 1.0);
  }

  const std::vector<BinnedColumn>& columns_;
  std::vector<std::vector<Folds>> classes_;
};

/// One-sided p of a mean gain above zero.
double blockwise_p(const Histograms& histograms, double least_samples) {
  std::array<double, kTreeFolds> gains{};
  for (int fold = 0; fold < kTreeFolds; ++fold) {
    const std::optional<Split> split = histograms.best(fold, least_samples);
    gains[static_cast<std::size_t>(fold)] = split ? histograms.gain_on(fold, *split) : 0.0;
  }
  const double mean = std::accumulate(gains.begin(), gains.end(), 0.0) / kTreeFolds;
  double squares = 0.0;
  for (const double gain : gains) squares += (gain - mean) * (gain - mean);
  if (!(mean > 0.0)) return 1.0;
  if (!(squares > 0.0)) return 0.0;
  const double t = mean / std::sqrt(squares / (kTreeFolds * (kTreeFolds - 1.0)));
  return boost::math::cdf(boost::math::complement(boost::math::students_t(kTreeFolds - 1), t));
}

class Grower {
 public:
  Grower(const Eigen::MatrixXd& features, const Eigen::VectorXd& error, const TreeOptions& options)
      : error_(error), options_(options), all_(static_cast<double>(error.size())), sum_(error.sum()) {
    for (Eigen::Index f = 0; f < features.cols(); ++f) columns_.push_back(binned(features.col(f)));
    const Eigen::Index blocks = std::max<Eigen::Index>(1, std::min(kBlocks, error.size()));
    for (Eigen::Index row = 0; row < error.size(); ++row)
      folds_.push_back(static_cast<int>(row * blocks / error.size()) % kTreeFolds);
  }

  RegressionTree grow() {
    tree_.leaf.assign(static_cast<std::size_t>(error_.size()), 0);
    if (!(sum_ > 0.0)) return {};
    tree_.nodes.emplace_back();
    for (std::size_t node = 0; node < tree_.nodes.size(); ++node)
      if (tree_.nodes[node].depth < options_.depth) split(static_cast<int>(node));
    return std::move(tree_);
  }

 private:
  std::vector<Eigen::Index> rows_of(int node) const {
    std::vector<Eigen::Index> rows;
    for (std::size_t row = 0; row < tree_.leaf.size(); ++row)
      if (tree_.leaf[row] == node) rows.push_back(static_cast<Eigen::Index>(row));
    return rows;
  }

  void split(int node) {
    const std::vector<Eigen::Index> rows = rows_of(node);
    const Histograms histograms(columns_, error_, rows, folds_);
    const double least = options_.least_share * all_;
    const std::optional<Split> split = histograms.best(std::nullopt, least);
    if (!split || split->gain < options_.least_gain * sum_) return;
    const double p = blockwise_p(histograms, (1.0 - 1.0 / kTreeFolds) * least);
    if (p > options_.level) return;
    RegressionTree::Node& parent = tree_.nodes[static_cast<std::size_t>(node)];
    parent.feature = static_cast<int>(split->feature);
    parent.threshold = histograms.threshold(*split);
    parent.gain = split->gain / sum_;
    parent.p = p;
    parent.left = static_cast<int>(tree_.nodes.size());
    parent.right = parent.left + 1;
    const RegressionTree::Node asked = parent;  // push_back may move the vector's elements
    add_child(node, asked.depth + 1, split->left);
    add_child(node, asked.depth + 1, split->whole - split->left);
    for (const Eigen::Index row : rows) {
      const auto r = static_cast<std::size_t>(row);
      tree_.leaf[r] = columns_[split->feature].bin[r] <= split->edge ? asked.left : asked.right;
    }
  }

  void add_child(int parent, int depth, const Mass& mass) {
    RegressionTree::Node child;
    child.parent = parent;
    child.depth = depth;
    child.share_of_error = mass.error / sum_;
    child.share_of_samples = mass.samples / all_;
    tree_.nodes.push_back(child);
  }

  const Eigen::VectorXd& error_;
  TreeOptions options_;
  double all_, sum_;
  std::vector<BinnedColumn> columns_;
  std::vector<int> folds_;
  RegressionTree tree_;
};

}  // namespace

RegressionTree grow_tree(const Eigen::MatrixXd& features, const Eigen::VectorXd& error, const TreeOptions& options) {
  return Grower(features, error, options).grow();
}

}  // namespace lacuna
