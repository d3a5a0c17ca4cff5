#pragma once

#include "fitting/analytic_models.h"
#include "fitting/recorded_spring.h"
#include "fitting/shooting/shooting_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace lacuna::analytic {

/// Recordings of a model, cut into segments of `length` s (0: whole trials), as a stage of a fit sees them.
struct MadeProblem {
  MadeProblem(std::unique_ptr<CompiledModel> made, ModelDefinition of, const std::vector<Trial>& trials,
              double length = 0.0, int workers = 1)
      : model(std::move(made)),
        definition(std::move(of)),
        predictor(*model, trials, {workers}),
        noise(sensor_noise(definition.structure.robot, trials)),
        states(definition.structure.robot, predictor, noise),
        space(definition.free),
        problem(predictor, space, make_segments(predictor, states, length, definition.start_values()), noise) {}
  MadeProblem(const MadeProblem&) = delete;
  MadeProblem& operator=(const MadeProblem&) = delete;

  Eigen::VectorXd at(const std::vector<double>& values) const { return space.to_coordinates(values); }
  /// Of these values, with the initial states at their guesses.
  std::vector<Eigen::VectorXd> residuals_at(const std::vector<double>& values) {
    std::vector<Eigen::VectorXd> residuals;
    EXPECT_TRUE(problem.residuals(problem.start(at(values)), residuals));
    return residuals;
  }

  std::unique_ptr<CompiledModel> model;
  ModelDefinition definition;
  TrialPredictor predictor;
  std::vector<ChannelNoise> noise;
  StartStates states;
  ParameterSpace space;
  ShootingProblem problem;
};

/// reading = f(values, t), without joints: no initial state is unknown.
inline MadeProblem formula_problem(const FormulaModel::Formula& formula, std::vector<FreeValue> free,
                                   const std::vector<Trial>& trials, double length = 0.0, int workers = 1) {
  return {std::make_unique<FormulaModel>(formula), define(std::move(free)), trials, length, workers};
}

/// A recording of such a reading.
inline Trial formula_trial(const FormulaModel::Formula& formula, const std::vector<double>& values, double duration,
                           double rate, double noise, std::uint64_t seed) {
  const auto samples = static_cast<Eigen::Index>(std::lround(duration * rate)) + 1;
  return record(FormulaModel(formula), values, regular_times(samples, rate), {}, {}, noise, seed);
}

/// The damped spring of recorded_spring.h, whose damping is 0.5/s: position and velocity of each segment's start are
/// unknown.
inline MadeProblem spring_problem(const std::vector<Trial>& trials, double length = 0.0, int workers = 1) {
  return {std::make_unique<OneJointModel>(spring), spring_definition(), trials, length, workers};
}

}  // namespace lacuna::analytic
