#include "refit/plant_model.h"

#include <span>

namespace hidden_effects {

std::size_t PlantModel::size() const {
  std::size_t count = free.size();
  for (const PlacedLaw& law : laws) count += law.kind->parameters.size();
  return count;
}

PlantSpec PlantModel::spec_at(const Eigen::VectorXd& values) const {
  PlantSpec at = spec;
  for (std::size_t i = 0; i < free.size(); ++i) free[i].of(at) = values[static_cast<Eigen::Index>(i)];
  return at;
}

Laws PlantModel::laws_at(const Eigen::VectorXd& values) const {
  Laws at;
  std::size_t next = free.size();
  for (const PlacedLaw& law : laws) {
    const std::span<const double> parameters(values.data() + next, law.kind->parameters.size());
    const bool everywhere = law.element == kEverywhere;
    const int first = everywhere ? 0 : law.element;
    const int end = everywhere ? elements_of(spec, law.kind->place) : law.element + 1;
    for (int element = first; element < end; ++element) at.push_back(law.kind->make(parameters, element));
    next += parameters.size();
  }
  return at;
}

Readings predict(const PlantModel& model, const Eigen::VectorXd& values, const Excitation& excitation,
                 const Start& start, double step) {
  const Laws laws = model.laws_at(values);
  Simulation plant(model.spec_at(values), laws, excitation, step);
  return read_sensors(plant.spec(), laws, simulate(plant, start, excitation.samples(), 1));
}

}  // namespace hidden_effects
