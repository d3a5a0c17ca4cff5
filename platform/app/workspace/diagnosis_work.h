#pragma once

#include "app/terminal/options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

struct DiagnoseOptions : CommonOptions {
  std::vector<std::string> among;  ///< effects to try; empty: all
  std::filesystem::path out;       ///< of pictures; empty: none
};

/// Diagnoses as `lacuna diagnose` does: from the database, or anew, or from where an earlier call was interrupted, and
/// prints the answer. Throws `BadInput`, `Interrupted` where it can be gone on with, `Error`.
void carry_out_diagnosis(DiagnoseOptions options);

}  // namespace lacuna
