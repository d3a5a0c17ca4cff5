#pragma once

#include "cases/make_case.h"
#include "cases/scales_of.h"

#include <functional>
#include <vector>

namespace hidden_effects {

/// The laws of the library wherever they apply on a plant; on all elements at once where they apply on each of several.
std::vector<PlacedLaw> library_laws(const PlantSpec& spec);

/// The library's law of the same effect at the same place.
PlacedLaw library_form(const PlacedLaw& law);

/// Bounds of a fit: those of the base's free values, times the nominal value unless that is 0; a law's parameter that
/// `at_size` never makes negative stays positive, as the library has it.
struct Bounds {
  Eigen::VectorXd lower, upper;
};
Bounds bounds_of(const PlantModel& model);

/// Shapes that a search for a law begins with, spread evenly; those that change nothing of `kind` are left out.
std::vector<Shape> first_shapes(const LawKind& kind, const Scales& scales, std::size_t most);

/// Parameters at which `rival` is, or in a limit comes close to, the dry friction `law` with `parameters` on the same
/// joint: without excess, with stiff bristles, alike in both directions. Empty where there are none.
std::vector<double> friction_limit(const PlacedLaw& rival, const PlacedLaw& law, const std::vector<double>& parameters,
                                   const Scales& scales);

/// Parameters of the same kind at a size: cogging of one period a turn, which is what gravity does on a hinge, as a
/// sine and as a cosine of its angle. None for other laws.
std::vector<std::function<std::vector<double>(double size)>> like_gravity(const PlacedLaw& rival, const PlantSpec& spec,
                                                                          const Scales& scales);

}  // namespace hidden_effects
