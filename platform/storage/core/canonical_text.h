#pragma once

#include <lacuna/effect_list.h>
#include <lacuna/engine_settings.h>
#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

#include "storage/core/records.h"

#include <span>
#include <string>

/// One text, and one digest, for what means the same: JSON with keys in alphabetical order,
/// numbers in the shortest form that reads back to the same bits.
namespace lacuna {

std::string canonical_text(const RobotSpec& robot);
/// Sorted by effect, where, id.
std::string canonical_text(const EffectList& effects);
std::string canonical_text(const EngineSettings& engine);
std::string canonical_text(const std::vector<FreeValueRecord>& free);

/// SHA-256 of a revision's parts.
std::string digest_of(const RevisionRecord& revision);
/// SHA-256 of everything in a trial that a fit can see: commands, measurements, what is known of
/// the start, declared noise. Its name and whether it is held out do not count.
std::string digest_of(const Trial& trial);
/// Of the trials that are fitted, in order; those held out do not count.
std::string digest_of_trials(std::span<const Trial> trials);

/// The inverse of `canonical_text`.
EffectList effects_from_text(const std::string& text);
std::vector<FreeValueRecord> free_from_text(const std::string& text);
EngineSettings engine_from_text(const std::string& text);

}  // namespace lacuna
