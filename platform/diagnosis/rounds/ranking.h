#pragma once

#include "diagnosis/candidates/contender.h"
#include "diagnosis/rounds/round.h"
#include "diagnosis/rounds/search_state.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace lacuna {

/// What a round of `contender` found, the chosen rival first, then the largest gain; the chosen one with its
/// look-alikes. `before`: what the contender gained over the model without any effect.
std::vector<RankedModel> ranking_of(const Contender& contender, const Round& round, std::optional<std::size_t> chosen,
                                    const Gain& before, std::uint64_t seed);

/// What later rounds need of a round of `contender`.
SearchStep step_of(const Contender& contender, const Round& round, std::size_t chosen);

/// Whether the model's last effect is `name`, "effect @ where".
bool is_last_effect(const RankedModel& model, const std::string& name);

/// Makes the model whose last effect is `name` the first, the others in their order; all without look-alikes.
void bring_to_front(std::vector<RankedModel>& ranking, const std::string& name);

}  // namespace lacuna
