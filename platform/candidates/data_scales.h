#pragma once

#include <lacuna/trial.h>

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// What counts as a typical size in these trials, by unit: the range of measured channels ("rad"), the speed that they
/// rarely exceed ("rad/s"), and the largest wave number whose waves their readings resolve, as far as a search tries
/// them
/// ("1/rad": rad in a unit). Where no channel reads a position, the range is how far its speed leads.
std::map<std::string, double> data_scales(const std::vector<Trial>& trials);

/// Values worth trying for a parameter of that unit which shapes an effect without switching it on, such as the
/// velocity of Stribeck's curve. Empty: its default is as good as any.
std::vector<double> shapes_to_try(const std::string& unit, const std::map<std::string, double>& scales);

/// Keeps free values that count waves in a unit, of the effects `added`, between one wave over the range (of an
/// angle, once a turn) and what readings resolve: a law that repeats faster fits anything, and one that does not
/// repeat is another law.
void bound_by_resolution(const std::vector<EffectEntry>& added, const std::map<std::string, double>& scales,
                         std::vector<FreeValue>& free);

}  // namespace lacuna
