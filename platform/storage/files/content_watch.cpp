#include "storage/files/content_watch.h"

#include "storage/files/callback.h"
#include "storage/files/foreign_log.h"
#include "storage/files/log_content.h"

#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <optional>
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

/// That of the database as SQLite reads it; one without numbers where it has none, nothing where it cannot be read.
std::optional<LogMark> mark_of_now(sqlite3* handle) {
  const auto take = [](void* text, int, char** values, char**) {
    return called_back([&] { *static_cast<std::string*>(text) = values[0] == nullptr ? "" : values[0]; });
  };
  std::string text;
  const int result = sqlite3_exec(handle, "SELECT sha256 FROM schema_text WHERE name = 'log'", take, &text, nullptr);
  if (result != SQLITE_OK && result != SQLITE_ERROR) return std::nullopt;  // an error: there is no such table
  const std::vector<LogMark> marks = marks_in(text);
  return marks.empty() ? LogMark{} : marks.front();
}

int data_version(sqlite3* handle) { return number_from(handle, "PRAGMA data_version"); }

/// Whether the pages that its first one counts are there.
bool is_whole(const RawFile& file, std::uint32_t page_size) {
  const FileHeader header(file.read(0, FileHeader::kSize));
  return header.is_database() && header.page_size() == page_size &&
         file.size() >= std::uint64_t{header.pages().value_or(1)} * page_size;
}

/// The marks of a log in the order of the commits, the one on which it was begun first.
struct Chain {
  std::vector<std::string> marks;
  std::ptrdiff_t in_file = 0;  ///< of the latest that is known to have been brought into the file
};

/// A checkpoint that cannot bring the whole log into the file leaves out pages that stand in the log again.
Chain chain_of(const std::filesystem::path& log, std::uint32_t frames_in_file) {
  Chain chain;
  std::uint32_t frames = 0;
  WriteAheadLog(log).for_each_frame([&](const LogFrame& frame) {
    ++frames;
    for (const LogMark& mark : marks_in(frame.content)) {
      if (chain.marks.empty()) chain.marks.push_back(mark.before);
      if (chain.marks.back() != mark.now) chain.marks.push_back(mark.now);
    }
    if (frame.pages_at_commit > 0)
      chain.in_file = frames <= frames_in_file ? std::max<std::ptrdiff_t>(0, std::ssize(chain.marks) - 1) : 0;
    return true;
  });
  return chain;
}

/// Of the latest of a file's marks; -1 where the chain has none of them.
std::ptrdiff_t place_in(const std::vector<std::string>& chain, const Marks& marks) {
  const auto is_there = [&](const std::string& mark) {
    return marks.contains(mark) || (marks.empty() && mark == kNoMark);
  };
  return std::distance(std::find_if(chain.rbegin(), chain.rend(), is_there), chain.rend()) - 1;
}

int checkpoint_if_own(void* watch, sqlite3* handle, const char* name, int frames) {
  called_back([&] {
    if (frames >= kFramesBeforeCheckpoint && static_cast<ContentWatch*>(watch)->is_own())
      sqlite3_wal_checkpoint_v2(handle, name, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
  });
  return SQLITE_OK;  // the commit is done, whatever becomes of the checkpoint
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
      version_(data_version(handle)),
      latest_(mark_of_now(handle).value_or(LogMark{}).now) {
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

/// A file holds what the checkpoints brought into it, or what one that is under way brings: the state of one of its
/// commits, but of none before.
bool ContentWatch::marks_follow(const Marks& marks, std::uint32_t frames_in_file) const {
  const Chain chain = chain_of(log_, frames_in_file);
  if (chain.marks.empty()) return marks_fit_without_log(marks);
  return place_in(chain.marks, marks) >= std::max(chain.in_file, place_in(chain.marks, seen_));
}

/// Everything was brought into the file, what others committed included, who took their log with them.
bool ContentWatch::marks_fit_without_log(const Marks& marks) const {
  if (marks.contains(latest_)) return true;
  const auto is_new = [&](const std::string& mark) { return !earlier_.contains(mark); };
  return others_committed() && std::any_of(marks.begin(), marks.end(), is_new);
}

bool ContentWatch::looks_own() {
  const Stamp now = stamp();  // before the look, so that a change during it is looked at next time
  const RawFile file(handle_);
  if (!is_whole(file, page_size_)) return false;
  const std::uint32_t frames_in_file = file.frames_in_file();  // also before: a checkpoint may be under way
  Marks marks = marks_there();
  if (!marks_follow(marks, frames_in_file)) return false;
  stamp_ = now;
  seen_ = std::move(marks);
  version_ = data_version(handle_);
  return true;
}

bool ContentWatch::is_continued() {
  for (int look = 0; look < kLooks; ++look) {
    if (look > 0) std::this_thread::sleep_for(kBetweenLooks);
    const std::optional<LogMark> now = mark_of_now(handle_);
    if (!now) return true;  // whoever reads or writes next gets the same fault, and says it
    if (latest_ == now->now) return true;
    if (!comes_after_latest(*now)) continue;
    go_on_to(now->now);
    return true;
  }
  return own_ = false;
}

/// Each commit names the one before. The part of the log that was moved into the file is gone.
bool ContentWatch::comes_after_latest(const LogMark& now) const {
  if (now.before == latest_) return true;
  if (earlier_.contains(now.now)) return false;
  std::map<std::string, std::string> before{{now.now, now.before}};
  bool log_has_latest = false;
  WriteAheadLog(log_).for_each_frame([&](const LogFrame& frame) {
    for (const LogMark& mark : marks_in(frame.content)) {
      before.emplace(mark.now, mark.before);
      log_has_latest = log_has_latest || mark.now == latest_ || mark.before == latest_;
    }
    return true;
  });
  Marks line{now.now};
  for (auto step = before.find(now.now); step != before.end() && line.insert(step->second).second;)
    step = before.find(step->second);
  if (log_has_latest) return line.contains(latest_);
  const Marks there = marks_there();
  return std::any_of(there.begin(), there.end(), [&](const std::string& mark) { return line.contains(mark); });
}

void ContentWatch::go_on_to(std::string mark) {
  earlier_.insert(seen_.begin(), seen_.end());
  earlier_.insert(std::exchange(latest_, std::move(mark)));
  earlier_.erase(latest_);
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
