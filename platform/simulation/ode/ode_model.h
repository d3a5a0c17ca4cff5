#pragma once

#include "simulation/compiled_model.h"
#include "simulation/shared/delay_line.h"
#include "simulation/shared/effect_schedule.h"
#include "simulation/shared/joint_tree.h"
#include "simulation/shared/model_instance.h"

#include <vector>

namespace lacuna::ode {

/// A model structure compiled for ODE: everything that does not depend on parameter values.
class OdeModel : public CompiledModel {
 public:
  OdeModel(ModelStructure structure, const EngineSettings& settings);

  const std::vector<Channel>& channels() const override { return channels_; }
  const std::vector<Coordinate>& coordinates() const override { return coordinates_; }
  const StateLayout& state_layout() const override { return layout_; }
  bool has_memory() const override;
  std::unique_ptr<Workspace> make_workspace() const override;
  void simulate(std::span<const double> parameters, const Test& test, const SimulationOptions& options,
                Workspace& workspace, SimulationResult& result) const override;

  const ModelStructure& structure() const { return structure_; }
  const EngineSettings& settings() const { return settings_; }
  const simulation::JointTree& tree() const { return tree_; }
  const simulation::ParameterSlots& slots() const { return slots_; }
  const simulation::EffectSchedule& effects() const { return effects_; }
  std::span<const simulation::Delay> longest_sensor_delays() const { return longest_sensor_delays_; }
  std::span<const simulation::Delay> longest_command_delays() const { return longest_command_delays_; }
  double step() const { return settings_.step / settings_.substeps; }
  std::size_t state_size() const { return layout_.back().offset + layout_.back().size; }  ///< without the controller's

 private:
  /// Finds the longest delays and the effects' state sizes that parameters within their bounds
  /// can ask for.
  void size_memory();
  void lay_out_state();

  ModelStructure structure_;  // effects in canonical order
  EngineSettings settings_;
  simulation::JointTree tree_;
  simulation::EffectSchedule effects_;
  simulation::ParameterSlots slots_;
  std::vector<Channel> channels_;
  std::vector<Coordinate> coordinates_;
  std::vector<simulation::Delay> longest_sensor_delays_, longest_command_delays_;
  StateLayout layout_;
};

}  // namespace lacuna::ode
