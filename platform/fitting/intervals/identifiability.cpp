#include "fitting/intervals/identifiability.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMatters = 0.1;  ///< of the direction's largest component
constexpr double kEqual = 0.03;   ///< relative changes that differ less are the same

/// A value that takes part in a direction which the data do not determine.
struct Part {
  std::string name;
  std::string unit;
  double change = 0.0;    ///< along the direction, in the value's unit
  double relative = 0.0;  ///< the same over the value, where that is not 0
};

std::vector<Part> parts_of(const Eigen::VectorXd& direction, const Uncertainty& uncertainty, const FitPoint& point,
                           const ParameterSpace& space, const std::vector<FreeValue>& free) {
  std::vector<Part> parts;
  for (Eigen::Index j = 0; j < direction.size(); ++j) {
    if (std::abs(direction(j)) <= kMatters * direction.cwiseAbs().maxCoeff()) continue;
    const double value = space.to_value(j, point.values(j));
    const double change = direction(j) * uncertainty.sizes(j) * space.slope(j, point.values(j));
    const FreeValue& of = free[static_cast<std::size_t>(j)];
    parts.push_back({of.address, of.unit, change, value != 0.0 ? change / value : direction(j)});
  }
  return parts;
}

std::string names_of(const std::vector<Part>& parts) {
  std::string text = parts.front().name;
  for (std::size_t i = 1; i < parts.size(); ++i) text += (i + 1 == parts.size() ? " and " : ", ") + parts[i].name;
  return text;
}

bool equal(double a, double b) { return std::abs(a - b) < kEqual * std::max(std::abs(a), std::abs(b)); }

/// The combination of two values that the data determine. Two equal values that change against each other keep both
/// their sum and their product: with a unit, as for two frictions, the sum is meant; for two plain factors, the
/// product.
std::string what_remains_of_two(const Part& a, const Part& b) {
  if (equal(a.relative, b.relative)) return "only their ratio";
  const bool product = equal(a.relative, -b.relative);
  const bool sum = a.unit == b.unit && equal(a.change, -b.change);
  if (sum && (!product || a.unit != "1")) return "only their sum";
  return product ? "only their product" : "only a combination of the two";
}

/// The combination of a group of values that the data determine.
std::string what_remains(const std::vector<Part>& parts) {
  if (parts.size() == 2) return what_remains_of_two(parts[0], parts[1]);
  const bool together = std::all_of(parts.begin(), parts.end(),
                                    [&](const Part& part) { return equal(part.relative, parts[0].relative); });
  return together ? "only their ratios" : "only combinations of them";
}

std::string sentence(const std::vector<Part>& parts) {
  if (parts.size() == 1) return "the data do not determine " + parts[0].name + ": any value within its bounds fits";
  if (parts.size() == 2)
    return "the data cannot tell " + parts[0].name + " from " + parts[1].name + " (" + what_remains(parts) + ")";
  return "the data cannot tell " + names_of(parts) + " apart (" + what_remains(parts) + ")";
}

}  // namespace

std::vector<std::string> undetermined_sentences(const Uncertainty& uncertainty, const FitPoint& point,
                                                const ParameterSpace& space, const std::vector<FreeValue>& free) {
  std::vector<std::string> sentences;
  for (const Eigen::VectorXd& direction : uncertainty.undetermined) {
    std::string text = sentence(parts_of(direction, uncertainty, point, space, free));
    if (std::find(sentences.begin(), sentences.end(), text) == sentences.end()) sentences.push_back(std::move(text));
  }
  return sentences;
}

}  // namespace lacuna
