#pragma once

#include <lacuna/trial.h>

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// What counts as a typical size in these trials, by unit: the range of measured channels ("rad"), and the speed that
/// they rarely exceed ("rad/s").
std::map<std::string, double> data_scales(const std::vector<Trial>& trials);

/// Values worth trying for a parameter of that unit which shapes an effect without switching it on, such as the
/// velocity of Stribeck's curve. Empty: its default is as good as any.
std::vector<double> shapes_to_try(const std::string& unit, const std::map<std::string, double>& scales);

}  // namespace lacuna
