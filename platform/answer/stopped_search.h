#pragma once

#include "answer/diagnosis.h"
#include "foundation/processes/stop.h"

#include <string>
#include <vector>

namespace lacuna {

/// The diagnosis where the time limit of `work` was reached during the step `during`, before any candidate was
/// examined.
Diagnosis stopped_before_search(const Experiment& experiment, const PluginCatalog& catalog,
                                const ModelDefinition& definition, const std::vector<std::string>& among,
                                std::string during, const Stop& work);

/// Marks a diagnosis as stopped by the time limit of `work`: it states no probability, and its findings begin with
/// that. Fills in `stop.next`. `kept_models`: how many models the next call need not fit again.
void mark_stopped(StoppedSearch stop, const Stop& work, std::size_t kept_models, Diagnosis& diagnosis);

/// Candidates for one more effect in a model, "name @ where".
std::vector<std::string> candidate_names(const Experiment& experiment, const PluginCatalog& catalog,
                                         const ModelDefinition& definition, const std::vector<std::string>& among);

}  // namespace lacuna
