#include "storage/reading_only.h"

#include "foundation/interrupt.h"

#include <sqlite3.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace lacuna {
namespace {

constexpr int kOperationsBetweenLooks = 10000;  ///< of SQLite's machine, well under a millisecond

int stop_if_due(void* reading) {
  return interrupt_requested() || static_cast<const ReadingOnly*>(reading)->out_of_time() ? 1 : 0;
}

/// Refuses what the read-only file itself would let pass: other files, pragmas that set something, extensions.
int allow_reading_only(void*, int action, const char* first, const char* second, const char*, const char*) {
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_READ:
    case SQLITE_RECURSIVE: return SQLITE_OK;
    case SQLITE_UPDATE:  // how table-valued pragmas declare themselves; a true update of it is refused by SQLite
      return std::string_view(first) == "sqlite_master" ? SQLITE_OK : SQLITE_DENY;
    case SQLITE_FUNCTION: return std::string_view(second) == "load_extension" ? SQLITE_DENY : SQLITE_OK;
    case SQLITE_PRAGMA: {
      static constexpr std::string_view kAsking[] = {"table_info",      "table_xinfo", "table_list",
                                                     "index_list",      "index_info",  "foreign_key_list",
                                                     "integrity_check", "quick_check", "foreign_key_check"};
      static constexpr std::string_view kAskingWithoutValue[] = {"user_version", "application_id", "journal_mode",
                                                                 "page_count",   "page_size",      "encoding"};
      const auto among = [&](const auto& names) {
        return std::find(std::begin(names), std::end(names), first) != std::end(names);
      };
      return among(kAsking) || (second == nullptr && among(kAskingWithoutValue)) ? SQLITE_OK : SQLITE_DENY;
    }
    default: return SQLITE_DENY;
  }
}

}  // namespace

ReadingOnly::ReadingOnly(sqlite3* handle, std::optional<std::chrono::milliseconds> longest)
    : handle_(handle), longest_(longest) {
  if (longest) end_ = std::chrono::steady_clock::now() + *longest;
  sqlite3_set_authorizer(handle_, allow_reading_only, nullptr);
  sqlite3_progress_handler(handle_, kOperationsBetweenLooks, stop_if_due, this);
}

ReadingOnly::~ReadingOnly() {
  sqlite3_set_authorizer(handle_, nullptr, nullptr);
  sqlite3_progress_handler(handle_, 0, nullptr, nullptr);
}

bool ReadingOnly::out_of_time() const { return end_ && std::chrono::steady_clock::now() > *end_; }

}  // namespace lacuna
