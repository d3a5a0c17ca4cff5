#include "fitting/shooting/parameter_space.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

ParameterSpace::ParameterSpace(const std::vector<FreeValue>& free) {
  const auto size = static_cast<Eigen::Index>(free.size());
  lower_.resize(size);
  upper_.resize(size);
  start_.resize(size);
  for (const FreeValue& value : free) logarithmic_.push_back(value.scale == Scale::logarithmic && value.lower > 0.0);
  for (Eigen::Index j = 0; j < size; ++j) {
    lower_(j) = to_coordinate(j, free[static_cast<std::size_t>(j)].lower);
    upper_(j) = to_coordinate(j, free[static_cast<std::size_t>(j)].upper);
    start_(j) = std::clamp(to_coordinate(j, free[static_cast<std::size_t>(j)].start), lower_(j), upper_(j));
  }
}

double ParameterSpace::to_coordinate(Eigen::Index j, double value) const {
  return logarithmic(j) ? std::log(value) : value;
}

double ParameterSpace::to_value(Eigen::Index j, double coordinate) const {
  if (!logarithmic(j)) return coordinate;
  return std::clamp(std::exp(coordinate), std::exp(lower_(j)), std::exp(upper_(j)));
}

std::vector<double> ParameterSpace::to_values(const Eigen::VectorXd& coordinates) const {
  std::vector<double> values;
  for (Eigen::Index j = 0; j < size(); ++j) values.push_back(to_value(j, coordinates(j)));
  return values;
}

Eigen::VectorXd ParameterSpace::to_coordinates(const std::vector<double>& values) const {
  Eigen::VectorXd coordinates(size());
  for (Eigen::Index j = 0; j < size(); ++j) coordinates(j) = to_coordinate(j, values[static_cast<std::size_t>(j)]);
  return clamp(coordinates);
}

double ParameterSpace::slope(Eigen::Index j, double coordinate) const {
  return logarithmic(j) ? to_value(j, coordinate) : 1.0;
}

}  // namespace lacuna
