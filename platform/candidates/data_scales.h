#pragma once

#include <lacuna/trial.h>

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// Typical sizes in these trials, by unit: the range of measured channels ("rad"), the speed that they rarely exceed
/// ("rad/s"), and the largest wave number that the readings resolve, within what a search tries ("1/rad": rad per
/// unit). Where no channel measures a position, its range is the speed times the duration.
std::map<std::string, double> data_scales(const std::vector<Trial>& trials);

/// Values to try for a parameter of that unit that shapes an effect without switching it on, such as the velocity of
/// Stribeck's curve. Empty: only its default.
std::vector<double> shapes_to_try(const std::string& unit, const std::map<std::string, double>& scales);

/// Limits wave numbers among the free values of the effects `added`: from one wave over the range (of an angle, one per
/// turn) up to the largest that readings resolve. A law that repeats faster fits any data; a law that does not repeat
/// is a different one.
void bound_by_resolution(const std::vector<EffectEntry>& added, const std::map<std::string, double>& scales,
                         std::vector<FreeValue>& free);

}  // namespace lacuna
