#include "simulation/shared/engine_workspace.h"

#include "simulation/shared/robot_checks.h"

#include <lacuna/error.h>

namespace lacuna::simulation {

EngineWorkspace::EngineWorkspace(const EngineModel& model)
    : instance(model.structure(), model.slots()),
      effects(model.effects(), instance),
      sensors(model.structure().robot, model.longest_sensor_delays()),
      drive(model.longest_command_delays(), model.settings()),
      motion(model.make_motion()),
      model_(model) {
  const std::size_t actuators = model.structure().robot.actuators.size();
  commands.resize(actuators);
  last_commands.resize(actuators);
  command_rates.resize(actuators);
  readings_before.resize(model.channels().size());
  output_row.resize(model.channels().size());
}

void EngineWorkspace::build(std::span<const double> parameters, const ParameterSlots::Slots& slots) {
  instance.set(parameters, slots);
  RobotSpec& robot = instance.robot();
  effects.amend(robot);
  if (const std::string complaint = unphysical(robot); !complaint.empty()) throw Error(complaint);
  sensors.configure(robot, model_.settings());
  if (!motion) motion = model_.make_motion();
  motion->build(robot);
}

std::vector<std::pair<std::string, std::size_t>> EngineWorkspace::sections() const {
  std::vector<std::pair<std::string, std::size_t>> sections{{"clock", 2}};
  for (const auto& section : motion->sections()) sections.push_back(section);
  sections.insert(sections.end(), {{"effects", model_.effects().state_size()},
                                   {"sensors", sensors.readings().size()},
                                   {"sensor_delays", sensors.delays_size()},
                                   {"accelerometers", sensors.last_motions_size()},
                                   {"commands", last_commands.size() + drive.lines_size()}});
  return sections;
}

void EngineWorkspace::save(double origin, std::uint64_t step, State& state) const {
  StateWriter writer(state.values);
  writer.put(origin);
  writer.put(static_cast<double>(step));
  motion->save(writer);
  effects.save(writer);
  sensors.save(writer);
  writer.put(last_commands);
  drive.save_lines(writer);
  drive.save_controller(writer);
}

std::pair<double, std::uint64_t> EngineWorkspace::saved_clock(const State& state) {
  StateReader reader(state.values);
  const double origin = reader.get();
  return {origin, static_cast<std::uint64_t>(reader.get())};
}

void EngineWorkspace::load(const State& state) {
  StateReader reader(state.values);
  reader.skip(2);  // the clock
  motion->load(reader);
  effects.load(reader);
  sensors.load(reader);
  reader.get(last_commands);
  drive.load_lines(reader);
  drive.load_controller(reader);
}

}  // namespace lacuna::simulation
