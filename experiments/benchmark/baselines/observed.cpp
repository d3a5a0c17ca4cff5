#include "baselines/observed.h"

#include <stdexcept>

namespace hidden_effects {

Eigen::VectorXd Observed::nominal() const {
  PlantSpec written = base.spec;
  Eigen::VectorXd values(static_cast<Eigen::Index>(base.free.size()));
  for (std::size_t i = 0; i < base.free.size(); ++i) values[static_cast<Eigen::Index>(i)] = base.free[i].of(written);
  return values;
}

Observed observed(const MadeCase& made, std::vector<std::string> withheld) {
  Observed seen{{made.base.spec, made.base.free, {}}, {}, std::move(withheld)};
  for (const MadeTrial& trial : made.trials)
    if (!trial.held_out) seen.trials.push_back(trial.fitted());
  if (seen.trials.size() < 2) throw std::invalid_argument("baselines leave trials out: they need two or more to fit");
  return seen;
}

}  // namespace hidden_effects
