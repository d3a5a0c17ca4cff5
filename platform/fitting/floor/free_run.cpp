#include "fitting/floor/free_run.h"

#include "fitting/numerics/scored_rms.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace lacuna {
namespace {

/// Parts of a trial between restarts, each with the first samples of the next.
std::vector<Stretch> parts_of_run(const TrialPredictor& predictor, const StartStates& states, std::size_t trial) {
  const double interval = states.restart(trial);
  const Eigen::VectorXd& times = predictor.trials()[trial].measured.times;
  const double* begin = times.data();
  const double* end = begin + times.size();
  const double first = times(0), last = times(times.size() - 1);
  if (!(first + interval + kHead < last) || !states.reconstructible(trial)) return {predictor.whole(trial)};
  std::vector<Stretch> parts;
  for (int k = 0; first + k * interval + kHead < last; ++k) {
    const double at = first + k * interval, until = at + interval + kHead;
    parts.push_back({trial, std::lower_bound(begin, end, at) - begin, std::upper_bound(begin, end, until) - begin});
  }
  parts.back().last = times.size();
  return parts;
}

/// The run of the pieces, each from the start that `start_of` gives it.
Prediction joined(const TrialPredictor& predictor, std::size_t trial, const std::vector<RunPiece>& pieces,
                  const std::function<StartState(const RunPiece&)>& start_of, std::span<const double> values,
                  int worker) {
  Prediction whole;
  if (pieces.size() == 1) {
    predictor.predict(predictor.whole(trial), values, start_of(pieces.front()), worker, whole);
    return whole;
  }
  const TimeSeries::Samples& measured = predictor.trials()[trial].measured.samples;
  whole.valid = true;
  whole.samples.setZero(measured.rows(), measured.cols());
  for (const RunPiece& piece : pieces) {
    Prediction part;
    predictor.predict({trial, piece.stretch.first, piece.stretch.last}, values, start_of(piece), worker, part);
    if (!part.valid) return part;
    const Eigen::Index from = &piece == &pieces.front() ? 0 : piece.first_scored;
    const Eigen::Index rows = piece.stretch.last - from;
    whole.samples.middleRows(from, rows) = part.samples.bottomRows(rows);
  }
  return whole;
}

}  // namespace

FreeRun free_run(const TrialPredictor& predictor, const StartStates& states, std::size_t trial,
                 std::span<const double> values, int worker) {
  FreeRun run;
  for (const Stretch& part : parts_of_run(predictor, states, trial)) {
    RunPiece piece{part, fit_head(predictor, states, part, values, worker), 0};
    piece.first_scored = first_scored(predictor, part, piece.start);
    if (piece.first_scored >= part.last && !run.pieces.empty()) continue;
    if (!run.pieces.empty())  // which continues until this one is scored
      run.pieces.back().stretch.last = std::max(run.pieces.back().stretch.last, piece.first_scored);
    run.pieces.push_back(std::move(piece));
  }
  run.start = run.pieces.front().start;
  run.first_scored = run.pieces.front().first_scored;
  run.prediction = predict_again(predictor, trial, run.pieces, values, worker);
  return run;
}

Prediction predict_again(const TrialPredictor& predictor, std::size_t trial, const std::vector<RunPiece>& pieces,
                         std::span<const double> values, int worker) {
  return joined(
      predictor, trial, pieces, [](const RunPiece& piece) { return piece.start.start; }, values, worker);
}

Eigen::VectorXd effect_of_start(const TrialPredictor& predictor, std::size_t trial, std::span<const double> values,
                                const FreeRun& run, int worker) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(run.prediction.samples.cols());
  for (Eigen::Index axis = 0; axis < run.start.axes.cols(); ++axis) {
    const auto is_still = [&](const RunPiece& piece) {
      return axis >= piece.start.axes.cols() || piece.start.axes.col(axis).isZero(0.0);
    };
    if (std::ranges::all_of(run.pieces, is_still)) continue;
    const Prediction moved = joined(
        predictor, trial, run.pieces,
        [&](const RunPiece& piece) { return is_still(piece) ? piece.start.start : moved_along(piece.start, axis); },
        values, worker);
    if (!moved.valid) continue;
    const TimeSeries::Samples change = moved.samples - run.prediction.samples;
    for (Eigen::Index c = 0; c < squares.size(); ++c)
      squares(c) += std::pow(scored_rms(change, c, run.first_scored), 2);
  }
  return squares.cwiseSqrt();
}

}  // namespace lacuna
