#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace lacuna::simulation {

/// Appends to a flat state vector.
class StateWriter {
 public:
  explicit StateWriter(std::vector<double>& values) : values_(values) { values_.clear(); }
  void put(double value) { values_.push_back(value); }
  void put(std::span<const double> values) { values_.insert(values_.end(), values.begin(), values.end()); }

 private:
  std::vector<double>& values_;
};

/// Reads a flat state vector in the order in which it was written; its size must have been checked.
class StateReader {
 public:
  explicit StateReader(std::span<const double> values) : values_(values) {}
  double get() { return values_[next_++]; }
  void skip(std::size_t count) { next_ += count; }
  void get(std::span<double> values) {
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(next_), values.size(), values.begin());
    next_ += values.size();
  }

 private:
  std::span<const double> values_;
  std::size_t next_ = 0;
};

}  // namespace lacuna::simulation
