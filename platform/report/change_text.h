#pragma once

#include "fitting/comparison.h"
#include "fitting/fit.h"

#include <string>

namespace lacuna {

/// A fitted revision and its errors on the fit files.
struct RevisionErrors {
  int revision = 0;
  FitResult fit;
  Comparison comparison;
};

/// What a change of the model did on the fit files: error by channel before → after, in units and
/// multiples of the floor, and the values that moved.
std::string change_text(const RevisionErrors& before, const RevisionErrors& after);
std::string change_json(const std::string& change, const RevisionErrors& before, const RevisionErrors& after);

}  // namespace lacuna
