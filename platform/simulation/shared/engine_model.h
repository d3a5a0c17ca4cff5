#pragma once

#include "simulation/compiled_model.h"
#include "simulation/shared/delay_line.h"
#include "simulation/shared/effect_schedule.h"
#include "simulation/shared/joint_tree.h"
#include "simulation/shared/model_instance.h"
#include "simulation/shared/robot_motion.h"

#include <functional>
#include <memory>
#include <vector>

namespace lacuna::simulation {

class EffectRunner;

/// A model structure compiled for an engine, without parameter values.
class EngineModel final : public CompiledModel {
 public:
  /// Makes a robot of the model's structure in motion.
  using MakeMotion = std::function<std::unique_ptr<RobotMotion>(const EngineModel&)>;

  /// Throws `Error` as `lacuna::compile` does.
  EngineModel(ModelStructure structure, const EngineSettings& settings, MakeMotion make_motion);

  std::unique_ptr<RobotMotion> make_motion() const { return make_motion_(*this); }

  const std::vector<Channel>& channels() const override { return channels_; }
  const std::vector<Coordinate>& coordinates() const override { return coordinates_; }
  const StateLayout& state_layout() const override { return layout_; }
  bool has_memory() const override;
  std::unique_ptr<Workspace> make_workspace() const override;
  void simulate(std::span<const double> parameters, const Test& test, const SimulationOptions& options,
                Workspace& workspace, SimulationResult& result) const override;

  const ModelStructure& structure() const { return structure_; }
  const EngineSettings& settings() const { return settings_; }
  const JointTree& tree() const { return tree_; }
  const ParameterSlots& slots() const { return slots_; }
  const EffectSchedule& effects() const { return effects_; }
  std::span<const Delay> longest_sensor_delays() const { return longest_sensor_delays_; }
  std::span<const Delay> longest_command_delays() const { return longest_command_delays_; }
  double step() const override { return settings_.step / settings_.substeps; }
  std::size_t state_size() const { return layout_.back().offset + layout_.back().size; }  ///< without the controller's

 private:
  /// Finds the longest delays and the effects' state sizes for parameters within their bounds.
  void size_memory();
  void lengthen_delays(ModelInstance& instance, EffectRunner& runner);
  void lay_out_state();

  ModelStructure structure_;  // effects in canonical order
  EngineSettings settings_;
  MakeMotion make_motion_;
  JointTree tree_;
  EffectSchedule effects_;
  ParameterSlots slots_;
  std::vector<Channel> channels_;
  std::vector<Coordinate> coordinates_;
  std::vector<Delay> longest_sensor_delays_, longest_command_delays_;
  StateLayout layout_;
};

}  // namespace lacuna::simulation
