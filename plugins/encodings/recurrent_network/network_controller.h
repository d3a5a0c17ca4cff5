#pragma once

#include <lacuna/test.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace lacuna {

/// A network with its weights, ready to run. No allocation and no virtual call in `act`.
class NetworkController final : public Controller {
 public:
  static constexpr std::size_t kMostHidden = 64;

  /// A neuron's output of −1 ... 1 becomes `middle` ± `half_range`.
  struct Output {
    double middle;
    double half_range;
  };

  /// `weights`: neuron after neuron, hidden ones first, each: sensors (hidden ones only), hidden, bias.
  NetworkController(std::size_t sensors, std::size_t hidden, std::vector<Output> outputs, std::vector<double> weights)
      : sensors_(sensors), hidden_(hidden), outputs_(std::move(outputs)), weights_(std::move(weights)) {}

  int state_size() const override { return static_cast<int>(hidden_); }

  void act(double, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override {
    const double* weight = weights_.data();
    std::array<double, kMostHidden> hidden;  // a neuron gets the others' previous activations
    for (std::size_t i = 0; i < hidden_; ++i) {
      double sum = 0.0;
      for (std::size_t s = 0; s < sensors_; ++s) sum += *weight++ * sensors[s];
      for (std::size_t h = 0; h < hidden_; ++h) sum += *weight++ * state[h];
      hidden[i] = activation(sum + *weight++);
    }
    std::copy_n(hidden.begin(), hidden_, state.begin());
    for (std::size_t a = 0; a < outputs_.size(); ++a) {
      double sum = 0.0;
      for (std::size_t h = 0; h < hidden_; ++h) sum += *weight++ * hidden[h];
      commands[a] = outputs_[a].middle + outputs_[a].half_range * activation(sum + *weight++);
    }
  }

 private:
  static double activation(double x) { return 2.0 / (1.0 + std::exp(-x)) - 1.0; }

  std::size_t sensors_;
  std::size_t hidden_;
  std::vector<Output> outputs_;
  std::vector<double> weights_;
};

}  // namespace lacuna
