#include "prediction/whitened_columns.h"

#include "prediction/start_prior.h"

namespace lacuna {

WhitenedColumns::WhitenedColumns(const PredictionLadder& ladder, const std::vector<LinearStretch>& stretches)
    : layout_(ladder.layout), values_(stretches.empty() ? 0 : stretches.front().values.cols()) {
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const PredictedStretch& stretch = ladder.stretches[k];
    const StartPrior prior = prior_of(stretch.covariance);
    for (std::size_t channel = 0; channel < ladder.noise.size(); ++channel) {
      Part part;
      part.stretch = k;
      part.cell = ladder.cell(stretch.length, channel);
      for (std::size_t i = 0; i < stretch.channels.size(); ++i)
        if (stretch.channels[i] == channel) {
          part.rows.push_back(static_cast<Eigen::Index>(i));
          part.blocks.push_back(stretch.blocks[i]);
        }
      if (part.rows.empty()) continue;
      part.by_start = stretches[k].start(part.rows, Eigen::all) * prior.deviation.asDiagonal();
      if (part.by_start.cols() > 0) {
        part.normal.compute(prior.precision + part.by_start.transpose() * part.by_start);
        part.root = prior.precision.llt().matrixU();
      }
      Eigen::MatrixXd known(static_cast<Eigen::Index>(part.rows.size()), values_ + 1);
      known.col(0) = stretches[k].residual(part.rows);
      known.rightCols(values_) = stretches[k].values(part.rows, Eigen::all);
      part.known = whitened(part, known);
      parts_.push_back(std::move(part));
    }
  }
}

Eigen::MatrixXd WhitenedColumns::whitened(const Part& part, const Eigen::MatrixXd& columns) {
  if (part.by_start.cols() == 0) return columns;
  const Eigen::MatrixXd moves = part.normal.solve(part.by_start.transpose() * columns);
  Eigen::MatrixXd result(columns.rows() + moves.rows(), columns.cols());
  result.topRows(columns.rows()) = columns - part.by_start * moves;
  result.bottomRows(moves.rows()) = part.root * moves;
  return result;
}

/// The cost of the start belongs to the first block.
void WhitenedColumns::add_products(const Part& part, const Eigen::MatrixXd& columns, BlockProducts& products) {
  const auto size = static_cast<Eigen::Index>(part.rows.size());
  const auto of_start = columns.bottomRows(columns.rows() - size);
  products.at(part.cell, part.blocks.front()) += of_start.transpose() * of_start;
  Eigen::Index begin = 0;
  while (begin < size) {
    const std::size_t block = part.blocks[static_cast<std::size_t>(begin)];
    Eigen::Index end = begin;
    while (end < size && part.blocks[static_cast<std::size_t>(end)] == block) ++end;
    const auto rows = columns.middleRows(begin, end - begin);
    products.at(part.cell, block) += rows.transpose() * rows;
    products.samples(part.cell, block) += static_cast<double>(end - begin);
    begin = end;
  }
}

BlockProducts WhitenedColumns::with(const std::vector<const PredictedChange*>& changes) const {
  const auto added = static_cast<Eigen::Index>(changes.size());
  BlockProducts products(layout_, values_ + added);
  for (const Part& part : parts_) {
    if (added == 0) {
      add_products(part, part.known, products);
      continue;
    }
    Eigen::MatrixXd own(static_cast<Eigen::Index>(part.rows.size()), added);
    for (Eigen::Index j = 0; j < added; ++j)
      own.col(j) = (*changes[static_cast<std::size_t>(j)])[part.stretch](part.rows);
    Eigen::MatrixXd all(part.known.rows(), values_ + 1 + added);
    all.leftCols(values_ + 1) = part.known;
    all.rightCols(added) = whitened(part, own);
    add_products(part, all, products);
  }
  return products;
}

BlockProducts whitened_products(const PredictionLadder& ladder, const std::vector<LinearStretch>& stretches) {
  return WhitenedColumns(ladder, stretches).with({});
}

}  // namespace lacuna
