#include "storage/core/one_state.h"

#include "storage/core/statement.h"

namespace lacuna {

void hold_one_state(const Database& database) {
  Statement(database, "BEGIN").run();
  Statement first(database, "SELECT count(*) FROM sqlite_schema");  // the state is that of the first look
  first.step();
}

}  // namespace lacuna
