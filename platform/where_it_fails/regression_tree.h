#pragma once

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// A shallow binary tree that divides samples by their features into regimes of small and large error (Breiman et al.,
/// "Classification and Regression Trees", 1984).
struct RegressionTree {
  struct Node {
    int parent = -1;
    int left = -1, right = -1;    ///< children; −1: a leaf
    int feature = -1;             ///< column of the split
    double threshold = 0.0;       ///< values below it go left
    int depth = 0;                ///< depth below the root, which has 0
    double share_of_error = 1.0;  ///< share of the sum over all samples
    double share_of_samples = 1.0;
    double gain = 0.0;  ///< information of the split on where the error occurs, nats
    double p = 1.0;     ///< p value of the split, from blocks that did not choose it
  };
  std::vector<Node> nodes;  ///< the root first; empty: no samples
  std::vector<int> leaf;    ///< the leaf of a sample
  bool grown() const { return nodes.size() > 1; }
};

struct TreeOptions {
  int depth = 3;
  double least_share = 0.03;  ///< of all samples, in a leaf
  double least_gain = 0.02;   ///< nats; a split with less gain is not worth a sentence
  /// Of a split's blockwise test; real splits are far below it unless the error has a long memory.
  double level = 0.03;
};

/// Divides the samples (rows of `features`, in the order of time) by `error` ≥ 0, their squared residual. A split is
/// the one with most information on where the error occurs: the largest Σ share · log(share of error/share of samples),
/// Poisson deviance. It stays only if other blocks confirm it: samples fall into ten folds of blocks along the time, a
/// split is chosen on nine and evaluated on the tenth, and the mean gain of all ten must exceed zero by Student's t.
RegressionTree grow_tree(const Eigen::MatrixXd& features, const Eigen::VectorXd& error,
                         const TreeOptions& options = {});

}  // namespace lacuna
