#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hidden_effects {

/// What predictions of held-out recordings cost (nats: mean log error over horizons and channels) under an experiment's
/// model with each of these sets of effects, "effect @ place": all fitted to the same recordings, from the same starts,
/// over the same lengths, with the same timing. NaN: a set that cannot be fitted, or nothing is held out. Throws
/// `lacuna::Error` for an experiment that cannot be read, or where nothing can be predicted.
std::vector<double> held_out_costs(const std::filesystem::path& experiment,
                                   const std::vector<std::vector<std::string>>& sets);

}  // namespace hidden_effects
