#pragma once

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// A shallow binary tree that parts samples by their features into regimes of small and large error (Breiman et al.,
/// "Classification and Regression Trees", 1984).
struct RegressionTree {
  struct Node {
    int parent = -1;
    int left = -1, right = -1;    ///< children; −1: a leaf
    int feature = -1;             ///< column that is asked
    double threshold = 0.0;       ///< values below it go left
    int depth = 0;                ///< of the root 0
    double share_of_error = 1.0;  ///< of the sum over all samples
    double share_of_samples = 1.0;
    double gain = 0.0;  ///< information of the split about where the error is, nats
    double p = 1.0;     ///< of the split, from blocks that it was not chosen on
  };
  std::vector<Node> nodes;  ///< the root first; empty: there was nothing to part
  std::vector<int> leaf;    ///< the node that a sample ends in
  bool grown() const { return nodes.size() > 1; }
};

struct TreeOptions {
  int depth = 3;
  double least_share = 0.03;  ///< of all samples, in a leaf
  double least_gain = 0.02;   ///< nats; less is no regime worth a sentence
  double level = 0.03;  ///< of a split's blockwise test, which falls far below it but where the error remembers long
};

/// Parts the samples (rows of `features`, in the order of time) by `error` ≥ 0, their squared residual. A split is the
/// one that tells most about where the error is: the largest Σ share · log(share of error/share of samples), Poisson
/// deviance. It stays only if blocks confirm it: samples fall into ten folds of blocks along the time, a split is
/// chosen on nine and judged on the tenth, and the mean gain of all ten must exceed zero by Student's t.
RegressionTree grow_tree(const Eigen::MatrixXd& features, const Eigen::VectorXd& error,
                         const TreeOptions& options = {});

}  // namespace lacuna
