#include "app/terminal/scratch_folder.h"

#include "foundation/processes/this_machine.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kName = "lacuna-scratch-", kKeptName = "lacuna-kept-";
constexpr std::chrono::hours kOld{24};

/// On some network file systems no other machine sees the lock.
std::string name_here() { return fmt::format("{}{}-", kName, digits_of_this_machine()); }

/// Removes folders of processes that were killed, whose locks have ended with them.
void remove_stale_ones(const fs::path& place) {
  std::error_code none;
  for (fs::directory_iterator entry(place, none), end; !none && entry != end; entry.increment(none)) {
    if (!entry->path().filename().string().starts_with(name_here())) continue;
    std::error_code gone;
    const fs::file_time_type changed = fs::last_write_time(entry->path(), gone);
    if (gone || fs::file_time_type::clock::now() - changed < kOld) continue;
    const int folder = ::open(entry->path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) continue;
    if (::flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry->path(), gone);
    ::close(folder);
  }
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::error_code missing;
  const std::filesystem::path place = std::filesystem::temp_directory_path(missing);
  if (missing) throw Error("the folder for temporary files ($TMPDIR) cannot be used: " + missing.message());
  remove_stale_ones(place);
  std::string name = (place / name_here()).string() + "XXXXXX";
  if (mkdtemp(name.data()) == nullptr)
    throw Error(fmt::format("{}: cannot be created: {}", name, std::strerror(errno)));
  path_ = name;
  lock_ = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ::flock(lock_, LOCK_EX | LOCK_NB);
}

ScratchFolder::~ScratchFolder() {
  if (lock_ >= 0) ::close(lock_);
  if (kept_) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void ScratchFolder::keep() {
  kept_ = true;
  path_ = keep_scratch(path_);
}

std::filesystem::path keep_scratch(const fs::path& folder) {
  std::string name = folder.filename().string();
  if (!name.starts_with(kName)) return folder;
  const fs::path kept = folder.parent_path() / name.replace(0, kName.size(), kKeptName);
  std::error_code failure;
  fs::rename(folder, kept, failure);
  return failure ? folder : kept;
}

}  // namespace lacuna
