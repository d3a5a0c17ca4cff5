#pragma once

#include "cases/make_case.h"

#include <cstdint>
#include <filesystem>

namespace hidden_effects {

/// The commands that `lacuna trial --csv` wrote for a test: one a sample for each drive, held in between. Throws
/// `std::runtime_error` for a file that is not that.
Excitation read_commands(const std::filesystem::path& file, const PlantSpec& spec, double interval);

/// A test carried out on the case's true plant and recorded as the case's trials are; its noise follows from `seed`.
/// Throws `std::runtime_error`.
MadeTrial carried_out_test(const MadeCase& made, const std::filesystem::path& commands, std::uint64_t seed);

}  // namespace hidden_effects
