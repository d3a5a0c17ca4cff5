#pragma once

#include "diagnosis/findings/diagnosis.h"

namespace lacuna {

/// Rules by which verdicts are read from errors by horizon.

/// Errors are so near their floor that likelihoods see smaller effects: these are about noise. Farther off, the law of
/// no model is right to the noise, and likelihoods are sure of anything.
bool is_near_floor(double most_times_floor);

/// At how many horizons and channels an answer lowers the error, of those at which the model stands above the floor.
struct Helped {
  int at = 0, of = 0;
  double share() const { return of > 0 ? static_cast<double>(at) / of : 1.0; }
};

/// Lowers: by a twentieth or more, of what was fitted and, where there is such data, of what was not.
Helped where_answer_helps(const std::vector<HorizonError>& horizons);

/// What is there helps at nearly every length; what helps at some lengths alone makes up for something else.
bool helps_everywhere(const Helped& helped);

/// A likelihood is believed far above the floor of predictions only where its own answer reaches its noise.
bool explains_to_noise(const Diagnosis& by_likelihood);

}  // namespace lacuna
