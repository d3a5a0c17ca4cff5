#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/test_encoding.h>

#include "network_controller.h"

#include <cmath>

namespace lacuna {

/// The seed's controllers (Bongard and Lipson, experiment 1): sensors, one layer of hidden neurons that also receive
/// each other's last activation, and actuators; a bias for hidden and output neurons. The genes are the weights, neuron
/// after neuron: S + H + 1 for each hidden one, H + 1 for each actuator; 68 for 8, 3 and 8. The README has the
/// equations. Commands lie within the space's bounds. A controller's state is the hidden activations, 0 at the start.
class RecurrentNetwork : public TestEncoding {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` where there is no actuator, one has no finite range, or a channel has a neuron's name.
  GenomeLayout layout(const TestSpace& space, std::span<const double> parameters) const override;
  Test decode(const TestSpace& space, std::span<const double> parameters,
              std::span<const double> genome) const override;
};

namespace {

enum Parameter : std::size_t { kHidden, kWeightLimit };

constexpr const char* kBias = "bias";
std::string hidden_name(std::size_t index) { return "hidden" + std::to_string(index + 1); }

/// Channels whose genes would have the name of a neuron's.
void check_names(const std::vector<Channel>& channels, std::size_t hidden) {
  for (const Channel& channel : channels) {
    bool taken = channel.name == kBias;
    for (std::size_t h = 0; h < hidden; ++h) taken = taken || channel.name == hidden_name(h);
    if (taken)
      throw Error("\"" + channel.name + "\" is a name of a neuron of the network; rename this part of the robot");
  }
}

void check_ranges(const TestSpace& space) {
  if (space.actuators.empty()) throw Error("the robot has no actuator for a controller");
  for (std::size_t a = 0; a < space.actuators.size(); ++a)
    if (!std::isfinite(space.lower[a]) || !std::isfinite(space.upper[a]) || space.lower[a] > space.upper[a])
      throw Error("commands of the actuator \"" + space.actuators[a].name +
                  "\" have no finite range; give it command_lower and command_upper");
}

std::vector<NetworkController::Output> outputs(const TestSpace& space) {
  std::vector<NetworkController::Output> outputs;
  for (std::size_t a = 0; a < space.actuators.size(); ++a)
    outputs.push_back({0.5 * (space.lower[a] + space.upper[a]), 0.5 * (space.upper[a] - space.lower[a])});
  return outputs;
}

std::size_t weight_count(std::size_t sensors, std::size_t hidden, std::size_t actuators) {
  return hidden * (sensors + hidden + 1) + actuators * (hidden + 1);
}

/// Weights of one neuron, in the order in which the controller reads them.
void add_neuron(GenomeLayout& layout, const std::string& name, const std::vector<Channel>& sensors, std::size_t hidden,
                double limit) {
  const auto add = [&](const std::string& from) {
    layout.genes.push_back({from + ">" + name, "1", GeneKind::real, -limit, limit});
  };
  for (const Channel& sensor : sensors) add(sensor.name);
  for (std::size_t h = 0; h < hidden; ++h) add(hidden_name(h));
  add(kBias);
}

}  // namespace

std::string RecurrentNetwork::summary() const {
  return "Controllers: a network of sensors, recurrent hidden neurons and actuators; the genes are its weights";
}

ParameterDeclarations RecurrentNetwork::parameters() const {
  return {{"hidden", "1", 3.0, 1.0, NetworkController::kMostHidden, Scale::linear, "Number of hidden neurons"},
          {"weight_limit", "1", 1.0, 1e-3, 1e3, Scale::logarithmic, "Largest magnitude of a weight"}};
}

GenomeLayout RecurrentNetwork::layout(const TestSpace& space, std::span<const double> parameters) const {
  const std::size_t hidden = count_parameter(this->parameters()[kHidden], parameters[kHidden]);
  check_ranges(space);
  check_names(space.sensors, hidden);
  check_names(space.actuators, hidden);
  GenomeLayout layout;
  for (std::size_t h = 0; h < hidden; ++h)
    add_neuron(layout, hidden_name(h), space.sensors, hidden, parameters[kWeightLimit]);
  for (const Channel& actuator : space.actuators)
    add_neuron(layout, actuator.name, {}, hidden, parameters[kWeightLimit]);
  return layout;
}

Test RecurrentNetwork::decode(const TestSpace& space, std::span<const double> parameters,
                              std::span<const double> genome) const {
  const auto hidden = static_cast<std::size_t>(parameters[kHidden]);
  const std::size_t weights = weight_count(space.sensors.size(), hidden, space.actuators.size());
  if (genome.size() != weights)
    throw Error("a genome of " + std::to_string(genome.size()) + " genes does not fit a network of " +
                std::to_string(weights) + " weights");
  Test test;
  test.drive = std::make_shared<NetworkController>(space.sensors.size(), hidden, outputs(space),
                                                   std::vector<double>(genome.begin(), genome.end()));
  test.duration = space.duration;
  return test;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestEncoding, lacuna::RecurrentNetwork>("recurrent_network"))
