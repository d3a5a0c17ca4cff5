#pragma once

#include <lacuna/trial.h>

#include "evaluation/model/model_definition.h"
#include "foundation/processes/stop.h"

#include <string>
#include <vector>

namespace lacuna {

/// How much a finding weakens a verdict.
enum class Severity {
  note,        ///< printed beside the verdict
  too_little,  ///< the data are short: a limit, printed
  fault        ///< what looks like an effect may be this fault
};

/// A finding of the data checks: a sentence with the file, the channel, the observation in numbers, and what to do.
struct DataWarning {
  Severity severity = Severity::note;
  std::string sentence;
  bool voids = false;  ///< no model can be right with such data: a found effect is not an answer
};

/// What is checked. Everything that it refers to must live until the findings are returned.
struct DataCheckTask {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;   ///< held-out ones are counted, not read
  const std::vector<double>& values;  ///< of the model, fitted or initial guesses
  bool saturation_is_tried = false;   ///< an effect that limits a sensor's range is among the candidates
  Stop stop = {};                     ///< of the work for which they are made
};

}  // namespace lacuna
