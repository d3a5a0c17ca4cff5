#pragma once

#include "app/workspace/open_experiment.h"

#include <string>
#include <vector>

namespace lacuna {

/// The elements of a robot that are of the given kinds, as `--where` names them.
std::vector<std::string> elements_of(const RobotSpec& robot, const std::vector<ElementKind>& kinds);

/// "say where: --where joint.rail or --where joint.hinge (coulomb_friction acts on joints)"; of a robot without such
/// an element, which it lacks. `places`: those that are possible.
std::string question_of_place(const std::string& effect, const std::vector<ElementKind>& kinds,
                              const std::vector<std::string>& places);

/// Where an effect is placed when the user does not say it: on the only element that the effect can be placed on; empty
/// for an effect that acts on the world, and for one that no plugin has. Throws `BadInput` where there are several
/// elements, or none.
std::vector<std::string> default_place(const OpenExperiment& opened, const std::string& effect);

}  // namespace lacuna
