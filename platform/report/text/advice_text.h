#pragma once

#include "fitting/comparison.h"

#include <string>

namespace lacuna {

/// What a comparison says about the model: that trials cannot be simulated, that a floor is not known, that the model
/// is at the floor, or that it is above it and an effect may be missing.
struct Advice {
  std::string result;         ///< sentences
  std::string next;           ///< what to do, or a command to type; empty where nothing follows
  bool is_explained = false;  ///< the noise and the initial-state uncertainty explain the error of all trials
};

/// What uncertain initial states do is no missing effect: the error is compared with the root of floor² + (k · start)²,
/// where k, between 2 for one trial and 1 for many, allows for chance. `diagnose`: the command that diagnoses.
Advice advice_on(const Comparison& comparison, const std::string& diagnose);

/// The same as one line.
std::string advice_text(const Comparison& comparison, const std::string& diagnose);

}  // namespace lacuna
