// Any text is asked of a database within the time and the size that pages allow, or is refused; nothing is written.

#include "fuzzing.h"
#include "storage/made_up_run.h"
#include "storage/pages/page_database.h"
#include "storage/queries/page_query.h"

#include <chrono>
#include <ctime>
#include <set>

namespace {

using lacuna::fuzz::require;

constexpr std::chrono::milliseconds kLongest{200};
constexpr double kMostWork = 2.0;  // s of a processor, which other programs may hold, for whatever is not interrupted
const std::set<std::string> kFiles = {"asked.db", "asked.db-shm", "pages.db"};
constexpr std::size_t kMostRows = 100;
constexpr std::size_t kMostBytes = 1U << 20U;

/// A user's database and the tables of its pages, beside which nothing may appear.
struct Asked {
  lacuna::TestFolder folder;
  std::filesystem::path database = folder / "asked.db", pages = folder / "pages.db";
  std::string content;

  Asked() {
    {
      lacuna::Database written = lacuna::Database::open(database);
      lacuna::ResultStore store(written);
      lacuna::test::fill_small_database(store);
      lacuna::test::add_made_up_run(written);
      lacuna::PageDatabase(pages).add_note("a note");
    }
    content = now();
  }
  std::string now() const { return lacuna::read_bytes(database) + lacuna::read_bytes(pages); }
  /// Readers leave an empty log and its index behind.
  bool stands_alone() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      const std::string name = entry.path().filename().string();
      if (name == "asked.db-wal" ? entry.file_size() > 0 : !kFiles.contains(name)) return false;
    }
    return true;
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Asked asked;
  const std::clock_t start = std::clock();
  lacuna::fuzz::is_done([&] {
    const lacuna::PageTable table =
        lacuna::ask_for_page(asked.database, asked.pages,
                             {.sql = lacuna::fuzz::text_of(data, size),
                              .values = {std::int64_t{1}, 0.5, std::string("angle"), std::monostate{}},
                              .most_rows = kMostRows,
                              .most_bytes = kMostBytes,
                              .sizes = size % 2 == 0,
                              .longest = kLongest});
    require(table.rows.size() <= kMostRows, "an answer has no more rows than were asked for");
    for (const auto& row : table.rows) require(row.size() == table.columns.size(), "there is a cell a column");
  });
  require(static_cast<double>(std::clock() - start) < kMostWork * CLOCKS_PER_SEC, "a question ends in its time");
  require(asked.now() == asked.content, "a question changes nothing");
  require(asked.stands_alone(), "a question makes no file");
  return 0;
}
