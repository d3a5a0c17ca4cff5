#include "support/simulation_run.h"

#include "support/tolerances.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lacuna {

SimulationRun::SimulationRun(RobotSpec robot, double step) {
  structure.robot = std::move(robot);
  engine.step = step;
  test.drive = CommandSeries{};
  for (const ActuatorSpec& actuator : structure.robot.actuators) command(actuator.name, 0.0);
}

SimulationRun& SimulationRun::from(std::vector<double> positions, std::vector<double> velocities) {
  test.start = {std::move(positions), std::move(velocities)};
  return *this;
}

SimulationRun& SimulationRun::command(const std::string& actuator, double value) {
  return command(actuator, {0.0}, {value}, Hold::zero_order);
}

SimulationRun& SimulationRun::command(const std::string& actuator, const std::vector<double>& times,
                                      const std::vector<double>& values, Hold hold) {
  CommandSeries commands{.series = {}, .hold = hold};
  commands.series.channels = {{actuator, "1"}};
  commands.series.times = Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
  commands.series.samples = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  test.drive = std::move(commands);
  return *this;
}

SimulationRun& SimulationRun::place(const PhysicalEffect& effect, ElementKind kind, std::vector<int> elements,
                                    std::vector<double> values) {
  const std::string id = "e" + std::to_string(structure.effects.size());
  PlacedEffect placed;
  placed.id = id;
  placed.name = "test_effect_" + id;
  placed.effect = &effect;
  placed.kind = kind;
  placed.elements = std::move(elements);
  placed.values = std::move(values);
  structure.effects.push_back(std::move(placed));
  return *this;
}

SimulationResult SimulationRun::run(const std::vector<double>& times) const { return carry_out(times, nullptr); }

SimulationResult SimulationRun::run(const std::vector<double>& times, const State& from) const {
  return carry_out(times, &from);
}

SimulationResult SimulationRun::carry_out(const std::vector<double>& times, const State* from) const {
  const auto model = compile(structure, engine);
  const auto workspace = model->make_workspace();
  SimulationOptions options;
  options.from = from;
  options.start = test.start;
  options.start_time = times.front();
  options.end_time = times.back();
  options.output_times = times;
  options.imperfections = imperfections;
  options.record_commands = record_commands;
  options.save_final_state = true;
  SimulationResult result;
  model->simulate(parameters, test, options, *workspace, result);
  if (result.ending != Ending::completed) throw Error("the simulation did not complete: " + result.reason);
  return result;
}

double SimulationRun::last(const std::string& channel, double end) const {
  return column(run({0.0, end}).readings, channel)(1);
}

Eigen::VectorXd column(const TimeSeries& series, const std::string& channel) {
  for (std::size_t i = 0; i < series.channels.size(); ++i)
    if (series.channels[i].name == channel) return series.samples.col(static_cast<Eigen::Index>(i));
  throw Error("there is no channel " + channel);
}

Eigen::Vector3d last_vector(const TimeSeries& series, const std::string& sensor) {
  const auto value = [&](const char* axis) { return column(series, sensor + axis)(series.times.size() - 1); };
  return {value(".x"), value(".y"), value(".z")};
}

void expect_convergence(const std::function<double(double step)>& error, double step, double bound) {
  const double coarse = error(step), middle = error(step / 2), fine = error(step / 4);
  EXPECT_LE(std::abs(coarse), bound);
  if (std::abs(coarse) <= kExact) return;
  for (const double ratio : {coarse / middle, middle / fine})
    EXPECT_GE(ratio, kHalvingRatioLow) << "errors " << coarse << ' ' << middle << ' ' << fine;
}

namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

void expect_same_bits_after_restore(const SimulationRun& run, const std::vector<double>& times, std::size_t middle) {
  const auto split = times.begin() + static_cast<std::ptrdiff_t>(middle);
  const SimulationResult whole = run.run(times);
  const SimulationResult first = run.run({times.begin(), split + 1});
  const SimulationResult second = run.run({split, times.end()}, first.final_state);
  EXPECT_EQ(whole.final_state, second.final_state);
  EXPECT_FALSE(first.final_state == second.final_state);
  ASSERT_EQ(second.readings.samples.rows() + static_cast<Eigen::Index>(middle), whole.readings.samples.rows());
  for (Eigen::Index row = 0; row < second.readings.samples.rows(); ++row)
    for (Eigen::Index channel = 0; channel < second.readings.samples.cols(); ++channel)
      ASSERT_TRUE(same_bits(second.readings.samples(row, channel),
                            whole.readings.samples(row + static_cast<Eigen::Index>(middle), channel)))
          << whole.readings.channels[static_cast<std::size_t>(channel)].name << " at sample " << row << " differs";
}

}  // namespace lacuna
