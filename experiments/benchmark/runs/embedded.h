#pragma once

namespace hidden_effects {

/// The texts of runs/schema.sql and figures/views.sql, which travel inside the program.
const char* schema_sql();
const char* views_sql();

}  // namespace hidden_effects
