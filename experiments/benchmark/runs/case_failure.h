#pragma once

#include <stdexcept>

namespace hidden_effects {

/// The program refused, crashed or took too long: a sentence of it.
class CaseFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Somebody asked for the end; the case is to be begun again another time.
class CaseStopped : public std::runtime_error {
 public:
  CaseStopped() : std::runtime_error("stopped") {}
};

}  // namespace hidden_effects
