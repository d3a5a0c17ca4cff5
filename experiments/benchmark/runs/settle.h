#pragma once

#include "cases/make_case.h"
#include "runs/records.h"
#include "runs/user_session.h"

#include <filesystem>
#include <optional>

namespace hidden_effects {

/// Does what a user would who wants to know which of two it is that a diagnosis does not tell apart: carries out the
/// test that is proposed on the true plant, adds its recording to the files, and asks `lacuna diagnose --among` these
/// two again; then the next proposal (or, where there is none any more, the last one with another seed), until one of
/// the two is named alone or there were `kMostSettlingTests`. The same from the beginning with random tests of the same
/// duration. Before either the two are asked about with no test; nothing is carried out where that does. The n-th
/// chosen and the n-th random test have noise of the same seeds.
///
/// Works in folders of its own within `folder`, from the files that the case began with. Nothing where the diagnosis
/// leaves no such question. What goes wrong is a sentence in the record. Throws `CaseStopped`.
std::optional<SettlingRecord> settle(const MadeCase& made, const DiagnosisRecord& first,
                                     const std::filesystem::path& folder, const ProgramSettings& settings);

}  // namespace hidden_effects
