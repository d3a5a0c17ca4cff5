#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace lacuna {

/// Predictions of one length in one channel: what is averaged before the logarithm is taken.
struct Cell {
  std::size_t length = 0;  ///< which of the lengths, from 0
  double weight = 0.0;     ///< of its cost; of all cells the weights sum to 1
};

/// What all models of a search have in common: cells, blocks of time, and which blocks are left out together.
struct CellLayout {
  std::vector<Cell> cells;
  std::size_t lengths = 0;
  std::vector<std::size_t> fold_of_block;  ///< by block of time
  std::size_t folds = 0;

  std::size_t blocks() const { return fold_of_block.size(); }
};

/// Products of a linearised model's whitened rows, summed by cell and block of time. A row holds the residual, then
/// what a unit of each value adds to the prediction; both over the standard deviation that a right model leaves.
class BlockProducts {
 public:
  using Product = Eigen::Map<Eigen::MatrixXd>;
  using ConstProduct = Eigen::Map<const Eigen::MatrixXd>;

  BlockProducts() = default;
  BlockProducts(const CellLayout& layout, Eigen::Index values)
      : blocks_(layout.blocks()),
        values_(values),
        products_(layout.cells.size() * blocks_ * size_of_product(), 0.0),
        samples_(layout.cells.size() * blocks_, 0.0) {}

  Eigen::Index values() const { return values_; }
  Product at(std::size_t cell, std::size_t block) { return {&products_[place(cell, block)], values_ + 1, values_ + 1}; }
  ConstProduct at(std::size_t cell, std::size_t block) const {
    return {&products_[place(cell, block)], values_ + 1, values_ + 1};
  }
  /// Of these values alone.
  BlockProducts part(const std::vector<Eigen::Index>& values) const {
    std::vector<Eigen::Index> rows = {0};
    for (const Eigen::Index value : values) rows.push_back(value + 1);
    BlockProducts some;
    some.blocks_ = blocks_;
    some.values_ = static_cast<Eigen::Index>(values.size());
    some.samples_ = samples_;
    some.products_.resize(samples_.size() * some.size_of_product());
    for (std::size_t i = 0; i < samples_.size(); ++i) some.at(0, i) = at(0, i)(rows, rows);
    return some;
  }
  double& samples(std::size_t cell, std::size_t block) { return samples_[cell * blocks_ + block]; }
  double samples(std::size_t cell, std::size_t block) const { return samples_[cell * blocks_ + block]; }

 private:
  std::size_t size_of_product() const { return static_cast<std::size_t>((values_ + 1) * (values_ + 1)); }
  std::size_t place(std::size_t cell, std::size_t block) const { return (cell * blocks_ + block) * size_of_product(); }

  std::size_t blocks_ = 0;
  Eigen::Index values_ = 0;
  std::vector<double> products_;  ///< one matrix behind the other
  std::vector<double> samples_;   ///< readings
};

}  // namespace lacuna
