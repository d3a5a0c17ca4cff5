#pragma once

#include <lacuna/trial.h>

#include "evaluation/model/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// How much a doubt takes from a verdict.
enum class Severity {
  note,        ///< to be said beside the verdict
  too_little,  ///< the data are short: a limit to be said
  fault        ///< what looks like an effect may be this
};

/// A reason to trust the data less: a sentence that names the file and the channel, what was seen in numbers, and what
/// to do.
struct Doubt {
  Severity severity = Severity::note;
  std::string sentence;
  bool voids = false;  ///< no model is right of such data: what is found is no answer
};

/// What is looked at. Everything referred to must live until the doubts are told.
struct DoubtTask {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;   ///< held-out ones are counted, not looked at
  const std::vector<double>& values;  ///< of the model, fitted or a guess
  bool saturation_is_tried = false;   ///< an effect that ends a sensor's range is among those searched
};

}  // namespace lacuna
