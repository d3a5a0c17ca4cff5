// A database of any bytes is verified, copied for pages and merged, or refused; it is never written to, and what it is
// merged into stays sound. The input is the file.

#include "fuzzing.h"
#include "storage/core/statement.h"
#include "storage/made_up_run.h"
#include "storage/merge/merge.h"
#include "storage/pages/page_database.h"
#include "storage/queries/verification.h"

namespace {

using lacuna::Database;
using lacuna::fuzz::is_done;
using lacuna::fuzz::require;

constexpr std::size_t kRoomForPages = 100'000;  // bytes; less than the seeds have, so that something is chosen

/// A database with runs of its own, some rows of which a shard has, too.
std::string bytes_of_host() {
  const lacuna::TestFolder folder;
  {
    Database database = Database::open(folder / "host.db");
    lacuna::ResultStore store(database);
    lacuna::test::fill_small_database(store);
  }
  return lacuna::read_bytes(folder / "host.db");
}

void require_sound(const Database& database) {
  lacuna::Statement check(database, "PRAGMA integrity_check");
  require(check.step() && check.text(0) == "ok", "what a shard was merged into is intact");
  lacuna::Statement keys(database, "PRAGMA foreign_key_check");
  require(!keys.step(), "what a shard was merged into refers to rows that are there");
}

void empty(const lacuna::TestFolder& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) std::filesystem::remove_all(entry);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string host = bytes_of_host();
  static const lacuna::TestFolder folder;
  const std::string bytes = lacuna::fuzz::text_of(data, size);
  empty(folder);
  const std::filesystem::path shard = folder.write("shard.db", bytes);
  is_done([&] { lacuna::verify(Database::open_read_only(shard)); });
  is_done([&] { lacuna::PageDatabase().copy(Database::open_read_only(shard), kRoomForPages); });
  {
    Database all = Database::open(folder.write("all.db", host));
    is_done([&] { lacuna::merge(all, {{shard}}); });
    require_sound(all);
  }
  require(lacuna::read_bytes(shard) == bytes, "nothing is written to a shard");
  return 0;
}
