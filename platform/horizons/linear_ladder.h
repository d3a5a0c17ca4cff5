#pragma once

#include "horizons/horizon_fit.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace lacuna {

/// By segment: what a change of the model by one unit adds to the prediction, channel units. A column a change.
using Responses = std::vector<Eigen::MatrixXd>;

/// The least cost that changes of a model can reach, to first order.
struct LinearFit {
  Eigen::VectorXd sizes;                         ///< of the changes: the model's own values, then those asked for
  std::vector<std::vector<double>> mean_square;  ///< by rung and channel
  double cost = 0.0;
};

/// A cost of which no block of time told the values by which it is predicted.
struct CrossFit {
  double cost = 0.0;
  Eigen::VectorXd by_block;    ///< what each block adds to the cost beyond its share of readings, nats
  Eigen::MatrixXd covariance;  ///< of the own values' coordinates, from how blocks of time differ
  int told = 0;                ///< how many values the data tell: the rank of what predictions change by
};

/// By how much a fit's values (coordinates) and refitted starts are to change.
struct LadderStep {
  Eigen::VectorXd values;
  std::vector<Eigen::VectorXd> states;
  double gain = 0.0;  ///< nats, to first order
};

/// A model fitted to a ladder, and to first order what changes do to its residuals: the model's own values, and any
/// number of further ones (a value of an effect that it lacks). All questions of what the change of a few is worth are
/// answered by sums over rows, without simulating anything.
class LinearLadder {
 public:
  /// `own`: responses by the model's own values, whose coordinates may move within `lower` and `upper`. `starts`: by
  /// segment, responses by what is refitted of its start, with `priors` (standard deviations); these give way to every
  /// change. `block`: s.
  struct Parts {
    const Ladder& ladder;
    const std::vector<Trial>& trials;
    const HorizonFit& fit;
    Responses own;
    Responses starts;
    std::vector<Eigen::VectorXd> priors;
    Eigen::VectorXd room_below, room_above;  ///< how far the own values may move, coordinates; both not negative
    double block = 0.0;
  };
  explicit LinearLadder(const Parts& parts);

  /// A further change, of which `at_least` … `at_most` units can be had. Its number.
  std::size_t add(const std::vector<Eigen::VectorXd>& response, double at_least, double at_most);

  /// The best sizes of the own values with these changes beside them.
  LinearFit best(std::span<const std::size_t> changes, double damping = 0.0) const;

  /// What was recorded is parted, by trial where there are three or more, else in so many `stretches` of time; each
  /// part is predicted with the own values that the others alone would have, to first order. Models on one ladder have
  /// the same blocks.
  CrossFit cross_fit(int stretches) const;

  /// The best step of the model's own values and starts; gains little where the fit has converged. `damping`: of the
  /// diagonal of the normal equations, for a shorter step (K. Levenberg, 1944; D. Marquardt, 1963).
  LadderStep step(double damping) const;

  double cost() const { return cost_; }  ///< of the model as it is
  int blocks() const { return blocks_; }

 private:
  /// Rows of one rung and channel, in the order of blocks.
  struct Cell {
    Eigen::Index first = 0, size = 0;
    double weight = 0.0, floor = 0.0, count = 0.0;
    std::size_t rung = 0, channel = 0;
  };
  struct Change {
    Eigen::VectorXd rows;
    double at_least, at_most;
    std::vector<Eigen::VectorXd> with_base;  ///< by cell: products with the residual and the own values
  };
  struct Place {
    std::size_t segment;
    Eigen::Index row;
    int block;
    double factor;  ///< that winsorises
  };

  void place_rows(const Parts& parts);
  void prepare_starts(const Parts& parts);
  /// In the order of cells, winsorised, with what the starts take on given away.
  Eigen::VectorXd gathered(const std::vector<Eigen::VectorXd>& by_segment) const;
  /// With these changes of the starts.
  Eigen::VectorXd gathered(const std::vector<Eigen::VectorXd>& by_segment,
                           const std::vector<Eigen::VectorXd>& answers) const;
  Eigen::MatrixXd products(const Cell& cell, std::size_t index, std::span<const std::size_t> changes) const;
  double cost_of_squares(const std::vector<Eigen::MatrixXd>& products, const Eigen::VectorXd& sizes,
                         std::vector<double>& means) const;
  Eigen::MatrixXd covariance(Eigen::MatrixXd normal) const;
  Eigen::MatrixXd between_rungs(const Eigen::MatrixXd& normal) const;

  std::size_t rungs_, channels_;
  std::vector<Cell> cells_;
  std::vector<Place> places_;
  std::vector<Eigen::VectorXd> weights_;  ///< by segment and row, of squares; the starts' refits
  Responses starts_;
  Responses refits_;  ///< by segment: the change of a start that answers a change of its rows; empty: none is refitted
  std::vector<Eigen::VectorXd> start_residuals_;  ///< by segment: `refits_` × residuals
  Responses start_own_;                           ///< by segment: `refits_` × responses by the own values
  Eigen::MatrixXd base_;                          ///< rows × residual and own values
  std::vector<Eigen::MatrixXd> base_products_;
  Eigen::VectorXd row_weights_;
  Eigen::VectorXd room_below_, room_above_;
  std::vector<Change> changes_;
  int blocks_ = 0, trials_ = 0;
  std::vector<int> trial_of_block_;
  double cost_ = 0.0;
};

/// A fitted model's, from derivatives at its fit. `block`: s.
LinearLadder linearise(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                       const HorizonFit& fit, double block);

}  // namespace lacuna
