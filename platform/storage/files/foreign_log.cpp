#include "storage/files/foreign_log.h"

#include "storage/files/connection.h"
#include "storage/files/file_marks.h"
#include "storage/files/log_content.h"
#include "storage/files/raw_file.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <thread>

namespace lacuna {
namespace {

constexpr std::chrono::milliseconds kPause{5}, kLongestWait{1000};  // for another process that looks at the same log

/// Marks in a log of the database to which it belongs.
struct LogEvidence {
  bool committed = false;
  bool shares_mark = false;  ///< one of its marks is that of the file
  std::uint32_t page_size = 0;
  std::uint32_t pages = 0;  ///< of the database after its last commit
  std::optional<FileHeader> first_page;
  std::optional<LogMark> first_mark;
  Marks marks;  ///< all, those before the first commit included
};

LogEvidence look_at(const std::filesystem::path& log, const RawFile& file, std::uint32_t page_size) {
  LogEvidence found;
  std::map<std::uint32_t, Marks> of_page;
  found.page_size = WriteAheadLog(log).for_each_frame([&](const LogFrame& frame) {
    if (frame.pages_at_commit > 0) found.pages = frame.pages_at_commit;
    found.committed = found.committed || frame.pages_at_commit > 0;
    if (frame.page == 1 && !found.first_page) found.first_page.emplace(frame.content);
    for (const LogMark& mark : marks_in(frame.content)) {
      if (!found.first_mark) found.first_mark = mark;
      found.marks.insert({mark.before, mark.now});
      if (page_size == 0 || frame.page == 0) continue;
      if (!of_page.contains(frame.page)) of_page.emplace(frame.page, marks_of_page(file, frame.page, page_size));
      const Marks& there = of_page.at(frame.page);
      found.shares_mark = found.shares_mark || there.contains(mark.before) || there.contains(mark.now);
    }
    return !found.shares_mark;
  });
  found.marks.erase(std::string(kNoMark));
  return found;
}

/// Without marks: a log that another program or an older version wrote.
bool contradicts(const LogEvidence& log, const FileHeader& file) {
  if (log.first_page) return !file.is_blank() && log.first_page->application() != file.application();
  return file.pages() && *file.pages() != log.pages;  // which changes on the first page only
}

bool log_is_foreign(const std::filesystem::path& log, const RawFile& file) {
  const FileHeader header(file.read(0, FileHeader::kSize));
  const LogEvidence found = look_at(log, file, header.is_database() ? header.page_size() : 0);
  if (found.shares_mark || !found.committed) return false;
  if (!header.is_database() || header.page_size() != found.page_size) return true;
  if (!found.first_mark) return contradicts(found, header);
  const Marks there = all_marks(file);
  if (there.empty()) return found.first_mark->before != kNoMark || contradicts(found, header);
  return std::none_of(there.begin(), there.end(), [&](const std::string& mark) { return found.marks.contains(mark); });
}

/// Before a transaction that writes its first page, a file has the change counter that the journal keeps; then the
/// next.
bool journal_is_foreign(const std::filesystem::path& file_of_journal, const RawFile& file) {
  const RollbackJournal journal = read_journal(file_of_journal);
  if (!journal.hot) return false;
  if (file.size() == 0) return journal.pages > 0;
  const FileHeader header(file.read(0, FileHeader::kSize));
  if (!header.is_database()) return journal.pages > 0;
  if (header.page_size() != journal.page_size) return true;
  if (!journal.first_page) return header.pages() && *header.pages() != journal.pages;
  const FileHeader& before = *journal.first_page;
  return header.change_counter() - before.change_counter() > 1 || header.application() != before.application() ||
         header.schema_counter() < before.schema_counter();
}

struct Found {
  std::filesystem::path file;
  bool (*is_foreign)(const std::filesystem::path&, const RawFile&);
};

std::string what_it_is(const std::filesystem::path& log, const std::filesystem::path& database) {
  return fmt::format("{}: contains changes to another database, not to the present {}", log.string(),
                     database.string());
}

std::string put_aside(const std::filesystem::path& log, const std::filesystem::path& database) {
  try {
    std::error_code ignored;
    // Only an index of the log, which SQLite makes again.
    if (log.string().ends_with("-wal")) std::filesystem::remove(beside(database, "-shm"), ignored);
    const std::filesystem::path aside = set_aside(log);
    const std::string tail = log.string().substr(log.string().rfind('-'));
    fmt::print(stderr,
               "{}; it was set aside as {}, and {} was not changed. If the other database still exists as FILE, move "
               "the set-aside file to FILE{} before FILE is opened; otherwise delete it\n",
               what_it_is(log, database), aside.string(), database.string(), tail);
    return {};
  } catch (const std::filesystem::filesystem_error& error) {
    return fmt::format("{}, and cannot be set aside ({})", what_it_is(log, database), error.code().message());
  }
}

/// A foreign log stays foreign, but a file that is being written may look foreign for a moment.
std::string examine(const Found& found, RawFile& file, const std::filesystem::path& database) {
  const auto end = std::chrono::steady_clock::now() + kLongestWait;
  while (has_content(found.file) && found.is_foreign(found.file, file)) {
    if (file.is_read_only()) return what_it_is(found.file, database) + ", and cannot be set aside";
    if (file.lock()) {
      const bool foreign = has_content(found.file) && found.is_foreign(found.file, file);
      std::string problem = foreign ? put_aside(found.file, database) : std::string();
      file.unlock();
      return problem;
    }
    if (std::chrono::steady_clock::now() > end) return {};  // in use by whoever has the database open
    std::this_thread::sleep_for(kPause);
  }
  return {};
}

}  // namespace

std::filesystem::path beside(const std::filesystem::path& database, const char* tail) {
  std::error_code missing;
  const std::filesystem::path true_name = std::filesystem::canonical(database, missing);
  return (missing ? database : true_name).string() + tail;
}

bool has_content(const std::filesystem::path& file) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(file, missing);
  return !missing && size > 0;
}

std::filesystem::path set_aside(const std::filesystem::path& file) {
  std::filesystem::path name = file.string() + ".set-aside";
  for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(name)); ++i)
    name = file.string() + ".set-aside-" + std::to_string(i);
  std::filesystem::rename(file, name);
  return name;
}

std::string put_foreign_log_aside(const std::filesystem::path& database) {
  const Found kinds[] = {{beside(database, "-wal"), &log_is_foreign},
                         {beside(database, "-journal"), &journal_is_foreign}};
  if (!has_content(kinds[0].file) && !has_content(kinds[1].file)) return {};
  try {
    const auto connection = open_connection(database.string(), SQLITE_OPEN_READWRITE);
    RawFile file(connection->getHandle());
    for (const Found& found : kinds)
      if (std::string problem = examine(found, file, database); !problem.empty()) return problem;
  } catch (const SQLite::Exception&) {
    // Whoever opens the file next gets the same fault, and says it.
  }
  return {};
}

}  // namespace lacuna
