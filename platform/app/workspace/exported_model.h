#pragma once

#include "app/workspace/experiment_workflow.h"
#include "evaluation/model/identified_robot.h"
#include "evaluation/robots/robot_export.h"

#include <filesystem>
#include <string>

namespace lacuna {

/// The comment at the top of an exported file: experiment, revision, and each fitted value with its interval.
std::string export_comment(const OpenExperiment& opened, int revision, const FitResult& fit);

/// The model table of an experiment in which the exported robot predicts what the model does, with `comment` at its
/// head: the file, values that it has no place for, and effects that no robot has, all fixed.
std::string exported_model_toml(const std::string& comment, const std::filesystem::path& robot_file,
                                const ModelSection& model, const IdentifiedRobot& identified,
                                const ExportedRobot& exported, bool has_base);

/// The rig as it was at an earlier revision of the experiment: with its effects and free values. Throws `Error` where
/// the database has no such revision, and where the experiment has changed otherwise since.
OpenExperiment experiment_of_revision(const CommonOptions& options, OpenExperiment now, int revision);

}  // namespace lacuna
