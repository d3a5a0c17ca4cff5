#pragma once

#include "cases/case_plan.h"
#include "plant/draw.h"

#include <utility>
#include <vector>

namespace hidden_effects {

template <class Value>
void shuffle(std::vector<Value>& values, Draw& draw) {
  for (std::size_t k = values.size(); k > 1; --k) std::swap(values[k - 1], values[draw.below(k)]);
}

/// One after the other of a list in shuffled order, again and again, each time in another order.
template <class Value>
class Turns {
 public:
  Turns(std::vector<Value> values, Draw& draw) : values_(std::move(values)), draw_(draw) {}
  const Value& next() {
    if (at_ == 0) shuffle(values_, draw_);
    const Value& value = values_[at_];
    at_ = (at_ + 1) % values_.size();
    return value;
  }

 private:
  std::vector<Value> values_;
  Draw& draw_;
  std::size_t at_ = 0;
};

/// A strength and a level of noise.
struct Cell {
  double strength;
  NoiseLevel noise;
};

/// All that are balanced in a set.
std::vector<Cell> all_cells();

}  // namespace hidden_effects
