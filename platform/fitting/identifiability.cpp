#include "fitting/identifiability.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kTakesPart = 0.1;  ///< of the direction's largest component
constexpr double kEqual = 0.03;     ///< relative changes that differ less are the same

/// The direction as relative changes of the values: d value / |value|.
Eigen::VectorXd relative_changes(const Eigen::VectorXd& direction, const Uncertainty& uncertainty,
                                 const FitPoint& point, const ParameterSpace& space) {
  Eigen::VectorXd changes = direction;
  for (Eigen::Index j = 0; j < changes.size(); ++j) {
    const double value = space.to_value(j, point.values(j));
    const double change = direction(j) * uncertainty.sizes(j) * space.slope(j, point.values(j));
    if (value != 0.0) changes(j) = change / value;
  }
  return changes;
}

std::string join(const std::vector<std::string>& names) {
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

/// What the data still tell of a pair or group that changes together.
std::string what_remains(const std::vector<double>& changes) {
  const double largest =
      *std::max_element(changes.begin(), changes.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto is = [&](double change, double wanted) { return std::abs(change - wanted) < kEqual * std::abs(largest); };
  const bool together = std::all_of(changes.begin(), changes.end(), [&](double c) { return is(c, changes[0]); });
  if (together) return changes.size() == 2 ? "only their ratio" : "only their ratios";
  if (changes.size() == 2 && is(changes[1], -changes[0])) return "only their product";
  return changes.size() == 2 ? "only a combination of the two" : "only combinations of them";
}

std::string sentence(const std::vector<std::string>& names, const std::vector<double>& changes) {
  if (names.size() == 1)
    return "the data do not show " + names.front() + ": no value within its bounds would be noticed";
  if (names.size() == 2)
    return "the data cannot tell " + names[0] + " from " + names[1] + " (" + what_remains(changes) + ")";
  return "the data cannot tell " + join(names) + " apart (" + what_remains(changes) + ")";
}

}  // namespace

std::vector<std::string> undetermined_sentences(const Uncertainty& uncertainty, const FitPoint& point,
                                                const ParameterSpace& space, const std::vector<FreeValue>& free) {
  std::vector<std::string> sentences;
  for (const Eigen::VectorXd& direction : uncertainty.undetermined) {
    const Eigen::VectorXd changes = relative_changes(direction, uncertainty, point, space);
    std::vector<std::string> names;
    std::vector<double> parts;
    for (Eigen::Index j = 0; j < direction.size(); ++j) {
      if (std::abs(direction(j)) <= kTakesPart * direction.cwiseAbs().maxCoeff()) continue;
      names.push_back(free[static_cast<std::size_t>(j)].address);
      parts.push_back(changes(j));
    }
    sentences.push_back(sentence(names, parts));
  }
  return sentences;
}

}  // namespace lacuna
