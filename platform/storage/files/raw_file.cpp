#include "storage/files/raw_file.h"

#include <sqlite3.h>

#include <cstring>

namespace lacuna {
namespace {

// The index of a write-ahead log: https://sqlite.org/walformat.html
constexpr int kIndexRegion = 32768;
constexpr std::size_t kBackfill = 96;

}  // namespace

RawFile::RawFile(sqlite3* handle) : handle_(handle) {
  sqlite3_file_control(handle, "main", SQLITE_FCNTL_FILE_POINTER, &file_);
}

std::string RawFile::read(std::uint64_t from, std::size_t size) const {
  std::string bytes(size, '\0');
  const int result =
      file_->pMethods->xRead(file_, bytes.data(), static_cast<int>(size), static_cast<sqlite3_int64>(from));
  return result == SQLITE_OK || result == SQLITE_IOERR_SHORT_READ ? bytes : std::string();
}

std::uint64_t RawFile::size() const {
  sqlite3_int64 size = 0;
  return file_->pMethods->xFileSize(file_, &size) == SQLITE_OK ? static_cast<std::uint64_t>(size) : 0;
}

bool RawFile::is_read_only() const { return sqlite3_db_readonly(handle_, "main") == 1; }

std::uint32_t RawFile::frames_in_file() const {
  const sqlite3_io_methods& methods = *file_->pMethods;
  void volatile* index = nullptr;
  if (methods.iVersion < 2 || methods.xShmMap(file_, 0, kIndexRegion, 0, &index) != SQLITE_OK || index == nullptr)
    return 0;
  std::uint32_t frames = 0;
  std::memcpy(&frames, const_cast<const char*>(static_cast<char volatile*>(index)) + kBackfill, sizeof frames);
  return frames;
}

bool RawFile::lock() {
  const bool locked = file_->pMethods->xLock(file_, SQLITE_LOCK_SHARED) == SQLITE_OK &&
                      file_->pMethods->xLock(file_, SQLITE_LOCK_EXCLUSIVE) == SQLITE_OK;
  if (!locked) unlock();
  return locked;
}

void RawFile::unlock() { file_->pMethods->xUnlock(file_, SQLITE_LOCK_NONE); }

}  // namespace lacuna
