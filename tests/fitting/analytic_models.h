#pragma once

#include "evaluation/model/model_definition.h"
#include "simulation/compiled_model.h"

#include <functional>

/// Models with known answers, made without an engine, and recordings of them.
namespace lacuna::analytic {

/// reading(t) = f(values, t): no joints, no commands.
class FormulaModel : public CompiledModel {
 public:
  using Formula = std::function<double(std::span<const double> values, double time)>;
  explicit FormulaModel(Formula formula) : formula_(std::move(formula)) {}

  const std::vector<Channel>& channels() const override { return channels_; }
  const std::vector<Coordinate>& coordinates() const override { return coordinates_; }
  const StateLayout& state_layout() const override { return layout_; }
  bool has_memory() const override { return false; }
  double step() const override { return 1e-3; }
  std::unique_ptr<Workspace> make_workspace() const override { return std::make_unique<Workspace>(); }
  void simulate(std::span<const double> values, const Test& test, const SimulationOptions& options,
                Workspace& workspace, SimulationResult& result) const override;

 private:
  Formula formula_;
  std::vector<Channel> channels_ = {{"y", "m"}};
  std::vector<Coordinate> coordinates_;
  StateLayout layout_;
};

/// One joint, q'' = f(values, q, v, command), by Runge and Kutta's fourth order in steps of at most 1 ms;
/// its position is measured as "angle". NaN makes the simulation invalid.
class OneJointModel : public CompiledModel {
 public:
  using Acceleration = std::function<double(std::span<const double> values, double q, double v, double command)>;
  explicit OneJointModel(Acceleration acceleration) : acceleration_(std::move(acceleration)) {}

  const std::vector<Channel>& channels() const override { return channels_; }
  const std::vector<Coordinate>& coordinates() const override { return coordinates_; }
  const StateLayout& state_layout() const override { return layout_; }
  bool has_memory() const override { return false; }
  double step() const override { return 1e-3; }
  std::unique_ptr<Workspace> make_workspace() const override { return std::make_unique<Workspace>(); }
  void simulate(std::span<const double> values, const Test& test, const SimulationOptions& options,
                Workspace& workspace, SimulationResult& result) const override;

 private:
  Acceleration acceleration_;
  std::vector<Channel> channels_ = {{"angle", "rad"}};
  std::vector<Coordinate> coordinates_ = {{"joint.hinge", "rad"}};
  StateLayout layout_;
};

/// A robot of one body on one hinge whose angle is measured: what a fit needs to know of a OneJointModel.
RobotSpec one_joint_robot();

/// A definition with these free values; `robot` is empty for a FormulaModel.
ModelDefinition define(std::vector<FreeValue> free, RobotSpec robot = {});

FreeValue free_value(std::string address, double start, double lower, double upper, Scale scale = Scale::linear);

/// Times k/rate for k below `samples`.
Eigen::VectorXd regular_times(Eigen::Index samples, double rate);

/// What the model reads, with white noise added to every channel; commands as given.
Trial record(const CompiledModel& model, const std::vector<double>& values, const Eigen::VectorXd& times,
             const CommandSeries& commands, const StartState& start, double noise, std::uint64_t seed);

/// A motor command of two sines at 100 Hz, zero-order hold.
CommandSeries two_sines(double duration, double amplitude);

}  // namespace lacuna::analytic
