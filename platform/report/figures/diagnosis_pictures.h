#pragma once

#include "answer/diagnosis.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Draws what a diagnosis found, and returns the files. `residual-force-JOINT.svg`, for each joint whose force is not
/// explained: a panel for its position, velocity and command with the force that follows it and the 95 % band, the
/// proposed formula in the title; the panels add up, so that a constant may stand in any of them. `ranking.svg`: the
/// held-out gain of each ranked model with its 95 % interval, beside what chance reaches in 5 % of cases. Nothing is
/// drawn of what the diagnosis does not hold. Throws `Error` as `write_svg` does.
std::vector<std::filesystem::path> draw_diagnosis(const Diagnosis& diagnosis, const std::string& title,
                                                  const std::filesystem::path& folder, const Stop& stop = {});

}  // namespace lacuna
