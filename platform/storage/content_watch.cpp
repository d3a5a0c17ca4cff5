#include "storage/content_watch.h"

#include "storage/foreign_log.h"
#include "storage/log_content.h"

#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

constexpr int kFramesBeforeCheckpoint = 1000;  // SQLite's own number
constexpr int kLooks = 40;                     // another process may be in the middle of a checkpoint
constexpr std::chrono::milliseconds kBetweenLooks{5};

/// The number that a statement answers; 0 where it cannot be asked.
int number_from(sqlite3* handle, const char* sql) {
  const auto take = [](void* number, int, char** values, char**) {
    *static_cast<int*>(number) = values[0] == nullptr ? 0 : std::atoi(values[0]);
    return 0;
  };
  int number = 0;
  return sqlite3_exec(handle, sql, take, &number, nullptr) == SQLITE_OK ? number : 0;
}

std::uint32_t size_from(sqlite3* handle, const char* sql) {
  return static_cast<std::uint32_t>(number_from(handle, sql));
}

int data_version(sqlite3* handle) { return number_from(handle, "PRAGMA data_version"); }

/// Whether the pages that its first one counts are there.
bool is_whole(const RawFile& file, std::uint32_t page_size) {
  const FileHeader header(file.read(0, FileHeader::kSize));
  return header.is_database() && header.page_size() == page_size &&
         file.size() >= std::uint64_t{header.pages().value_or(1)} * page_size;
}

/// The marks of a log in the order of the commits, the one on which it was begun first.
std::vector<std::string> chain_of(const std::filesystem::path& log) {
  std::vector<std::string> chain;
  WriteAheadLog(log).for_each_frame([&](const LogFrame& frame) {
    for (const LogMark& mark : marks_in(frame.content)) {
      if (chain.empty()) chain.push_back(mark.before);
      if (chain.back() != mark.now) chain.push_back(mark.now);
    }
    return true;
  });
  return chain;
}

/// Of the latest of these marks; -1 where the chain has none of them.
std::ptrdiff_t place_in(const std::vector<std::string>& chain, const Marks& marks) {
  const auto latest =
      std::find_if(chain.rbegin(), chain.rend(), [&](const std::string& mark) { return marks.contains(mark); });
  return std::distance(latest, chain.rend()) - 1;
}

int checkpoint_if_own(void* watch, sqlite3* handle, const char* name, int frames) {
  if (frames >= kFramesBeforeCheckpoint && static_cast<ContentWatch*>(watch)->is_own())
    sqlite3_wal_checkpoint_v2(handle, name, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
  return SQLITE_OK;
}

}  // namespace

ContentWatch::ContentWatch(std::filesystem::path file, sqlite3* handle)
    : file_(std::move(file)),
      log_(beside(file_, "-wal")),
      handle_(handle),
      page_size_(size_from(handle, "PRAGMA page_size")),
      page_of_mark_(size_from(handle, "SELECT rootpage FROM sqlite_master WHERE name = 'schema_text'")),
      stamp_(stamp()),
      seen_(marks_there()),
      version_(data_version(handle)) {
  sqlite3_wal_hook(handle, &checkpoint_if_own, this);
}

ContentWatch::~ContentWatch() { sqlite3_wal_autocheckpoint(handle_, kFramesBeforeCheckpoint); }

ContentWatch::Stamp ContentWatch::stamp() const {
  struct stat status {};
  if (stat(file_.c_str(), &status) != 0) return {};
  return {status.st_size, status.st_ctim.tv_sec, status.st_ctim.tv_nsec};
}

Marks ContentWatch::marks_there() const {
  const RawFile file(handle_);
  Marks marks = marks_of_page(file, page_of_mark_, page_size_);
  return marks.empty() ? all_marks(file) : marks;
}

bool ContentWatch::others_committed() const {
  const int now = data_version(handle_);
  return now != 0 && now != version_;
}

/// A file only becomes newer: the state of one of its commits, but of none before the one that was seen last.
bool ContentWatch::marks_follow(const Marks& marks) const {
  if (marks == seen_ || marks.contains(last_commit_)) return true;
  std::vector<std::string> chain = chain_of(log_);
  if (chain.empty() && others_committed()) return true;  // they took their log with them
  if (std::find(chain.begin(), chain.end(), last_commit_) == chain.end()) chain.insert(chain.begin(), last_commit_);
  return place_in(chain, marks) >= std::max<std::ptrdiff_t>(0, place_in(chain, seen_));
}

bool ContentWatch::looks_own() {
  const Stamp now = stamp();  // before the look, so that a change during it is looked at next time
  if (!is_whole(RawFile(handle_), page_size_)) return false;
  Marks marks = marks_there();
  if (!marks_follow(marks)) return false;
  stamp_ = now;
  seen_ = std::move(marks);
  version_ = data_version(handle_);
  return true;
}

bool ContentWatch::is_own() {
  if (!own_ || stamp() == stamp_) return own_;
  for (int look = 0; look < kLooks; ++look) {
    if (look > 0) std::this_thread::sleep_for(kBetweenLooks);
    if (looks_own()) return true;
  }
  return own_ = false;
}

}  // namespace lacuna
