#pragma once

#include <lacuna/trial.h>

#include "evaluation/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// A state of the experiment's model that errors can be told for: digests are equal exactly when
/// robot, free values, effects (in canonical order), engine settings and fit data are.
struct Revision {
  std::string digest;       ///< SHA-256 of the parts below
  std::string robot;        ///< JSON, the whole spec
  std::string free_values;  ///< JSON array
  std::string effects;      ///< JSON array, canonical order
  std::string engine;       ///< JSON
  std::string data_digest;  ///< of the fit trials
};

Revision revision_of(const ModelDefinition& model, const std::vector<Trial>& trials);

/// Digest of a trial's numbers: commands, measurements, what is known of its start.
std::string digest_of(const Trial& trial);

/// Effects as JSON and back; what the database keeps of a revision's effects.
std::string to_json(const EffectList& effects);
EffectList effects_from_json(const std::string& text);

}  // namespace lacuna
