#pragma once

#include "plugin_checks/exercise.h"

#include <lacuna/plugin.h>

#include <functional>
#include <memory>

namespace lacuna {

/// The exercise of a component of each kind; the component must outlive it. Uses only the interfaces.
std::unique_ptr<Exercise> exercise_of(const PhysicalEffect& effect, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const RobotDefinition& robot, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const RobotFormat& format, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const RecordingFormat& format, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const FitnessMetric& metric, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const ModelEncoding& encoding, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const TestEncoding& encoding, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const MutationOperator& mutation, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const SearchStrategy& strategy, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const TestFitness& fitness, const ExerciseInputs& inputs);
std::unique_ptr<Exercise> exercise_of(const ObjectiveMetric& metric, const ExerciseInputs& inputs);

/// Targets have a state, so each repetition makes a new one.
using TargetMaker = std::function<std::unique_ptr<TargetSystem>()>;
std::unique_ptr<Exercise> exercise_of_target(TargetMaker make, const ExerciseInputs& inputs);

}  // namespace lacuna
