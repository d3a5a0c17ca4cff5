#include "faults/failing_calls.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdarg>
#include <cstdlib>
#include <string_view>

/// Loaded into the program (LD_PRELOAD), in place of functions of the C library: see failing_calls.h.
namespace {

using lacuna::FailureCount;

struct Plan {
  std::string_view folder;
  FailureCount* count = nullptr;
  std::uint64_t at = 0;
  bool allocations = false, lasting = false;
};
Plan plan;
std::atomic<bool> begun = false;  ///< this process has made a call on a file of the folder

const char* variable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

__attribute__((constructor)) void read_plan() {
  const std::string_view folder = variable("LACUNA_FAIL_FOLDER");
  const int file =
      static_cast<int>(::syscall(SYS_openat, AT_FDCWD, variable("LACUNA_FAIL_COUNT"), O_RDWR | O_CLOEXEC, 0));
  if (folder.empty() || file < 0) return;
  void* const count = reinterpret_cast<void*>(
      ::syscall(SYS_mmap, nullptr, sizeof(FailureCount), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
  ::syscall(SYS_close, file);
  if (count == MAP_FAILED) return;
  plan = {.folder = folder,
          .count = static_cast<FailureCount*>(count),
          .at = std::strtoull(variable("LACUNA_FAIL_AT"), nullptr, 10),
          .allocations = std::string_view(variable("LACUNA_FAIL_WHAT")) == "allocations",
          .lasting = std::string_view(variable("LACUNA_FAIL_LASTING")) == "yes"};
}

/// Counts a call; whether it is to fail.
bool counts_and_fails() {
  const std::uint64_t number = ++plan.count->calls;
  const bool fails = plan.at > 0 && (number == plan.at || (plan.lasting && number > plan.at));
  if (fails) ++plan.count->failures;
  return fails;
}

bool call_fails(int error) {
  begun = true;
  if (plan.allocations || !counts_and_fails()) return false;
  errno = error;
  return true;
}

bool allocation_fails() {
  if (plan.count == nullptr || !plan.allocations || !begun || !counts_and_fails()) return false;
  errno = ENOMEM;
  return true;
}

/// The program works in the folder.
bool is_ours(const char* path) {
  if (plan.count == nullptr) return false;
  const std::string_view name(path);
  return !name.starts_with('/') || name.starts_with(plan.folder);
}

bool is_ours(int descriptor) {
  if (plan.count == nullptr || descriptor < 0) return false;
  std::array<char, 64> link{"/proc/self/fd/"};
  std::array<char, 16> digits{};
  std::size_t count = 0, end = std::string_view(link.data()).size();
  for (int rest = descriptor; rest > 0 || count == 0; rest /= 10) digits[count++] = static_cast<char>('0' + rest % 10);
  while (count > 0) link[end++] = digits[--count];
  std::array<char, 512> target{};
  const int before = errno;
  const long size = ::syscall(SYS_readlink, link.data(), target.data(), target.size());
  errno = before;
  return size > 0 && std::string_view(target.data(), static_cast<std::size_t>(size)).starts_with(plan.folder);
}

int open_at(int folder, const char* path, int flags, mode_t mode) {
  if (is_ours(path) && call_fails((flags & O_ACCMODE) == O_RDONLY ? EIO : ENOSPC)) return -1;
  return static_cast<int>(::syscall(SYS_openat, folder, path, flags | O_LARGEFILE, mode));
}

mode_t mode_of(int flags, std::va_list rest) {
  const bool has_mode = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
  return has_mode ? va_arg(rest, mode_t) : 0;
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) noexcept { return allocation_fails() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) noexcept {
  return allocation_fails() ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept { return allocation_fails() ? nullptr : __libc_realloc(old, size); }
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return allocation_fails() ? nullptr : __libc_memalign(alignment, size);
}

int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(AT_FDCWD, path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(AT_FDCWD, path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(folder, path, flags, mode);
}
int openat64(int folder, const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(folder, path, flags, mode);
}

ssize_t read(int file, void* bytes, std::size_t size) {
  return is_ours(file) && call_fails(EIO) ? -1 : ::syscall(SYS_read, file, bytes, size);
}
ssize_t pread64(int file, void* bytes, std::size_t size, off64_t at) {
  return is_ours(file) && call_fails(EIO) ? -1 : ::syscall(SYS_pread64, file, bytes, size, at);
}
ssize_t pread(int file, void* bytes, std::size_t size, off_t at) { return pread64(file, bytes, size, at); }
ssize_t write(int file, const void* bytes, std::size_t size) {
  return is_ours(file) && call_fails(ENOSPC) ? -1 : ::syscall(SYS_write, file, bytes, size);
}
ssize_t writev(int file, const struct iovec* parts, int count) {
  return is_ours(file) && call_fails(ENOSPC) ? -1 : ::syscall(SYS_writev, file, parts, count);
}
ssize_t pwrite64(int file, const void* bytes, std::size_t size, off64_t at) {
  return is_ours(file) && call_fails(ENOSPC) ? -1 : ::syscall(SYS_pwrite64, file, bytes, size, at);
}
ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t at) { return pwrite64(file, bytes, size, at); }

int fsync(int file) { return is_ours(file) && call_fails(EIO) ? -1 : static_cast<int>(::syscall(SYS_fsync, file)); }
int fdatasync(int file) {
  return is_ours(file) && call_fails(EIO) ? -1 : static_cast<int>(::syscall(SYS_fdatasync, file));
}
int ftruncate64(int file, off64_t size) noexcept {
  return is_ours(file) && call_fails(EIO) ? -1 : static_cast<int>(::syscall(SYS_ftruncate, file, size));
}
int ftruncate(int file, off_t size) noexcept { return ftruncate64(file, size); }

/// It is closed all the same.
int close(int file) {
  const bool ours = is_ours(file);
  const int closed = static_cast<int>(::syscall(SYS_close, file));
  return ours && call_fails(EIO) ? -1 : closed;
}

void* mmap64(void* address, std::size_t size, int protection, int flags, int file, off64_t at) noexcept {
  if ((flags & MAP_ANONYMOUS) == 0 && is_ours(file) && call_fails(ENOMEM)) return MAP_FAILED;
  return reinterpret_cast<void*>(::syscall(SYS_mmap, address, size, protection, flags, file, at));
}
void* mmap(void* address, std::size_t size, int protection, int flags, int file, off_t at) noexcept {
  return mmap64(address, size, protection, flags, file, at);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned int flags) noexcept {
  if (is_ours(to) && call_fails(EIO)) return -1;
  return static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
}
int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
  return renameat2(from_folder, from, to_folder, to, 0);
}
int rename(const char* from, const char* to) noexcept { return renameat2(AT_FDCWD, from, AT_FDCWD, to, 0); }
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  if (is_ours(to) && call_fails(EIO)) return -1;
  return static_cast<int>(::syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}
int link(const char* from, const char* to) noexcept { return linkat(AT_FDCWD, from, AT_FDCWD, to, 0); }
int unlinkat(int folder, const char* path, int flags) noexcept {
  return is_ours(path) && call_fails(EIO) ? -1 : static_cast<int>(::syscall(SYS_unlinkat, folder, path, flags));
}
int unlink(const char* path) noexcept { return unlinkat(AT_FDCWD, path, 0); }

}  // extern "C"
