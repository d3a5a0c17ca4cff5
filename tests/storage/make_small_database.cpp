#include "storage/made_up_run.h"

/// Writes the database of the documentation's examples: make_small_database FILE.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  lacuna::Database database = lacuna::Database::open(argv[1]);
  lacuna::ResultStore store(database);
  lacuna::test::fill_small_database(store);
  lacuna::test::add_made_up_run(database);
}
