#include "baselines/candidate.h"

#include "cases/scales_of.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr std::array kSizes = {1.0, 0.3, 3.0};

/// The k-th of a sequence that fills the cube evenly (M. Roberts' generalised golden ratio, in eight dimensions).
Shape shape_of(std::size_t k) {
  constexpr double kRatio = 1.0850702454914508;  // x⁹ = x + 1
  Shape shape;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const double place = 0.25 + static_cast<double>(k) * std::pow(kRatio, -static_cast<double>(i + 1));
    shape[i] = place - std::floor(place);
  }
  return shape;
}

}  // namespace

std::vector<Try> Candidate::tries(std::size_t count) const {
  std::vector<Try> all;
  for (std::size_t k = 0; k < count; ++k) {
    Try one{kSizes[k % kSizes.size()], shape_of(k), {}};
    one.parameters = at_size(one.size, one.shape);
    const auto same = [&](const Try& other) { return other.parameters == one.parameters; };
    if (std::none_of(all.begin(), all.end(), same)) all.push_back(std::move(one));
  }
  return all;
}

std::vector<Candidate> all_candidates(const Observed& seen, const RecordedMotions& motions) {
  std::vector<Candidate> all;
  for (const LawKind& kind : all_laws()) {
    const bool withheld = std::find(seen.withheld.begin(), seen.withheld.end(), kind.effect) != seen.withheld.end();
    if (!kind.library_form || withheld) continue;
    for (int e = 0; e < elements_of(seen.base.spec, kind.place); ++e)
      if (kind.applies(seen.base.spec, e)) all.push_back({{&kind, e}, recorded_scales(seen, motions, kind.place, e)});
  }
  return all;
}

PlantModel with_law(const PlantModel& base, const PlacedLaw& law) {
  PlantModel model = base;
  model.laws.push_back(law);
  return model;
}

Eigen::VectorXd with_parameters(const Eigen::VectorXd& values, const std::vector<double>& parameters) {
  Eigen::VectorXd all(values.size() + static_cast<Eigen::Index>(parameters.size()));
  all << values, Eigen::Map<const Eigen::VectorXd>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
  return all;
}

}  // namespace hidden_effects
