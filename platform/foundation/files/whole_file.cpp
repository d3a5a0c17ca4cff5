#include "foundation/files/whole_file.h"

#include "foundation/files/allowed_files.h"
#include "foundation/files/special_file.h"
#include "foundation/processes/this_machine.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kNewFile = 0666;  // minus the umask
constexpr mode_t kPermissions = 07777;

constexpr const char* kNobodyReads = "it is a pipe without a reader; start its reader first, or name a file";

[[noreturn]] void fail(const fs::path& file) {
  if (errno == ENXIO) throw Error(file.string() + ": cannot be written: " + kNobodyReads);
  throw Error(file.string() + ": cannot be written: " + std::strerror(errno));
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// /dev/stdout and the like: links to descriptors, not to a file that could be replaced.
bool names_descriptor(const fs::path& file) {
  std::error_code none;
  const std::string folder = fs::canonical(folder_of(file), none).string();
  return folder == "/dev" || folder.starts_with("/proc/");
}

/// The file that a name leads to. It is a link itself only where links form a circle.
fs::path end_of_links(fs::path file) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code none;
  for (int links = 0; links < kMostLinks && fs::is_symlink(file, none) && !names_descriptor(file); ++links)
    file = folder_of(file) / fs::read_symlink(file, none);
  return file;
}

/// Such a link leads to no file: it is damaged, or another one was meant, so it is not replaced.
bool is_circle(const fs::path& target) {
  std::error_code none;
  return fs::is_symlink(target, none) && !names_descriptor(target);
}

bool is_written_directly(const fs::path& target) {
  std::error_code none;
  return names_descriptor(target) || (fs::exists(target, none) && !fs::is_regular_file(target, none));
}

bool is_pipe(const fs::path& target) {
  std::error_code none;
  return fs::is_fifo(target, none);
}

int open_directly(const fs::path& target, const Stop& stop) {
  return is_pipe(target) ? open_pipe_to_reader(target, stop)
                         : ::open(target.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
}

/// Whether a pipe has a reader. The reader would see an end if the pipe were closed again before the first write, so it
/// stays open until the process ends.
std::optional<std::string> why_not_writable_pipe(const fs::path& target, const Stop& stop) {
  if (open_pipe_to_reader(target, stop) >= 0) return std::nullopt;
  return errno == ENXIO ? kNobodyReads : std::strerror(errno);
}

constexpr std::size_t kDigits = 8;  // behind the machine's
constexpr std::chrono::hours kOld{1};

/// Beginning of the names of this machine's drafts: on some network file systems other machines do not see their locks.
std::string kind_of_draft() { return ".lacuna-" + digits_of_this_machine(); }
/// Of drafts that a library writes, on which this program holds no lock. They have their process's number instead.
std::string kind_of_librarys() { return kind_of_draft() + "-"; }
std::string kind_of_own_librarys() {
  return fmt::format("{}{}-{}-", kind_of_librarys(), digits_of_this_start(), ::getpid());
}

fs::path unused_name(const fs::path& folder, const std::string& kind) {
  std::random_device random;
  return folder / fmt::format("{}{:08x}", kind, random());
}

/// The writer of a draft holds this lock on it until the process ends.
bool lock(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool is_old(const fs::path& draft) {
  std::error_code gone;
  const fs::file_time_type changed = fs::last_write_time(draft, gone);
  return !gone && fs::file_time_type::clock::now() - changed > kOld;
}

/// Whether the process in the name of a library's draft has ended; false where this is unknown.
bool has_lost_process(const std::string& name) {
  const std::string here = kind_of_librarys() + digits_of_this_start() + "-";
  if (digits_of_this_start().empty() || !name.starts_with(here)) return false;
  const int process = std::atoi(name.c_str() + here.size());
  return process > 0 && ::kill(process, 0) != 0 && errno == ESRCH;
}

/// A draft of this machine whose process may have ended.
bool may_be_stale(const fs::path& draft) {
  const std::string name = draft.filename().string(), kind = kind_of_draft();
  if (name.starts_with(kind_of_librarys())) return has_lost_process(name) || is_old(draft);
  return name.starts_with(kind) && name.size() == kind.size() + kDigits;
}

/// Removes the drafts of processes of this machine that were killed.
void remove_stale_drafts(const fs::path& folder) {
  std::error_code none;
  for (fs::directory_iterator entry(folder, none), end; !none && entry != end; entry.increment(none)) {
    if (!may_be_stale(entry->path())) continue;
    const int draft = ::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (draft < 0) continue;
    if (lock(draft)) ::unlink(entry->path().c_str());
    ::close(draft);
  }
}

void keep_owner_and_permissions(int descriptor, const struct stat& old) {
  struct stat now {};
  if (::fstat(descriptor, &now) == 0 && (now.st_uid != old.st_uid || now.st_gid != old.st_gid) &&
      ::fchown(descriptor, old.st_uid, old.st_gid) != 0) {
    // Only root can give a file away; for other users the new file is their own.
  }
  ::fchmod(descriptor, old.st_mode & kPermissions);
}

struct Draft {
  int descriptor = -1;  ///< below 0: `errno` says why there is none
  fs::path name;        ///< empty: it has none
};

Draft open_draft(const fs::path& folder, mode_t mode) {
  remove_stale_drafts(folder);
  if (::access("/proc/self/fd", X_OK) == 0) {  // path by which an unnamed file gets a name
    const int unnamed = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
    if (unnamed >= 0 && lock(unnamed)) return {unnamed, {}};
    if (unnamed >= 0) ::close(unnamed);
  }
  const fs::path name = unused_name(folder, kind_of_draft());
  const int named = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
  if (named < 0) return {};
  lock(named);  // may fail where another process has just removed it as stale: then `publish` reports that it is gone
  return {named, name};
}

}  // namespace

WholeFile::WholeFile(const fs::path& file, Link link, const Stop& stop)
    : file_(file),
      target_(link == Link::followed ? end_of_links(file) : file),
      direct_(link == Link::followed && is_written_directly(target_)),
      stream_(nullptr) {
  check_may_write(target_);
  if (link == Link::followed && is_circle(target_))
    throw Error(file_.string() + ": cannot be written: " + kCircleOfLinks);
  struct stat old {};
  const bool replaces = !direct_ && ::lstat(target_.c_str(), &old) == 0 && S_ISREG(old.st_mode);
  if (replaces && ::access(target_.c_str(), W_OK) != 0) fail(file_);
  const Draft draft = direct_ ? Draft{open_directly(target_, stop), {}}
                              : open_draft(folder_of(target_), replaces ? old.st_mode & kPermissions : kNewFile);
  if (draft.descriptor < 0) fail(file_);
  draft_ = draft.name;
  if (replaces) keep_owner_and_permissions(draft.descriptor, old);
  buffer_.emplace(draft.descriptor, std::ios::out | std::ios::binary);
  stream_.rdbuf(&*buffer_);
}

WholeFile::~WholeFile() {
  if (!draft_.empty()) ::unlink(draft_.c_str());
}

void WholeFile::finish() {
  if (stream_.flush() && (direct_ || ::fsync(buffer_->fd()) == 0)) return;
  throw Error(file_.string() +
              ": cannot be written completely; check that its folder is writable and the disk not full" +
              (direct_ ? "" : "; the previous content is kept"));
}

/// False where a file has that name.
bool WholeFile::give_name(const fs::path& name) {
  const std::string descriptor = fmt::format("/proc/self/fd/{}", buffer_->fd());
  return ::linkat(AT_FDCWD, descriptor.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

/// The same for a draft with a name. Some file systems have no links, others no such renaming.
bool WholeFile::rename_draft(const fs::path& name) {
  if (::renameat2(AT_FDCWD, draft_.c_str(), AT_FDCWD, name.c_str(), RENAME_NOREPLACE) == 0) {
    draft_.clear();
    return true;
  }
  return errno == EINVAL && ::link(draft_.c_str(), name.c_str()) == 0;
}

void WholeFile::name_draft(const std::string& kind) {
  const fs::path name = unused_name(folder_of(target_), kind);
  if (!(draft_.empty() ? give_name(name) : rename_draft(name))) fail(file_);
  draft_ = name;
}

/// On some network file systems one descriptor's lock blocks another one of the same process.
const fs::path& WholeFile::named_draft() {
  name_draft(kind_of_own_librarys());
  ::flock(buffer_->fd(), LOCK_UN);
  return draft_;
}

void WholeFile::publish() {
  finish();
  if (direct_) return;
  if (draft_.empty()) name_draft(kind_of_draft());
  if (::rename(draft_.c_str(), target_.c_str()) != 0) fail(file_);
  draft_.clear();
}

void WholeFile::publish_as_new() {
  finish();
  if (direct_) return;
  if (!(draft_.empty() ? give_name(target_) : rename_draft(target_))) fail(file_);
}

void write_whole(const fs::path& file, std::string_view text, Link link, Existing existing, const Stop& stop) {
  WholeFile whole(file, link, stop);
  whole.stream() << text;
  existing == Existing::refused ? whole.publish_as_new() : whole.publish();
}

fs::path place_of(const fs::path& file) {
  std::error_code failure;
  const fs::path name = fs::absolute(end_of_links(file), failure);
  const fs::path place = fs::weakly_canonical(name, failure);
  return failure ? name.lexically_normal() : place;
}

bool are_one_file(const fs::path& a, const fs::path& b) {
  std::error_code missing;
  return fs::equivalent(a, b, missing) || place_of(a) == place_of(b);
}

bool is_replaceable(const fs::path& file) {
  const fs::path target = end_of_links(file);
  std::error_code none;
  return fs::is_regular_file(target, none) && !is_written_directly(target);
}

std::optional<std::string> why_not_writable(const fs::path& file, const Stop& stop) {
  const fs::path target = end_of_links(file);
  if (is_circle(target)) return kCircleOfLinks;
  struct stat old {};
  const bool is_new = ::lstat(target.c_str(), &old) != 0 && errno == ENOENT;
  if (is_new && !is_written_directly(target)) return why_not_writable_into(folder_of(target));
  if (::access(target.c_str(), W_OK) != 0) return std::strerror(errno);
  if (S_ISBLK(old.st_mode)) return "it is a disk; name a file";
  if (is_pipe(target)) return why_not_writable_pipe(target, stop);
  return is_written_directly(target) ? std::nullopt : why_not_writable_into(folder_of(target));
}

std::optional<std::string> why_not_writable_into(const fs::path& folder) {
  if (::access(folder.c_str(), W_OK) != 0) return fmt::format("folder {}: {}", folder.string(), std::strerror(errno));
  const Draft probe = open_draft(folder, kNewFile);
  if (probe.descriptor < 0)
    return fmt::format("folder {} cannot be written to: {}", folder.string(), std::strerror(errno));
  if (!probe.name.empty()) ::unlink(probe.name.c_str());
  ::close(probe.descriptor);
  return std::nullopt;
}

}  // namespace lacuna
