#include "cases/turns.h"

#include <array>

namespace hidden_effects {
namespace {

constexpr std::array kStrengths = {1.5, 3.0, 10.0};
constexpr std::array kNoises = {NoiseLevel::white, NoiseLevel::coloured, NoiseLevel::disturbed};

}  // namespace

std::vector<Cell> all_cells() {
  std::vector<Cell> all;
  for (const double strength : kStrengths)
    for (const NoiseLevel noise : kNoises) all.push_back({strength, noise});
  return all;
}

}  // namespace hidden_effects
