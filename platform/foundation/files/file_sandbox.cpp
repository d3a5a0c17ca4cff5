#include "foundation/files/file_sandbox.h"

#include "foundation/files/allowed_files.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace lacuna {
namespace {

// Headers of older systems lack the later ones.
constexpr std::uint64_t kExecute = 1U << 0U, kWriteFile = 1U << 1U, kReadFile = 1U << 2U, kReadFolder = 1U << 3U;
constexpr std::uint64_t kOfFirstVersion = (1U << 13U) - 1U;
constexpr std::uint64_t kMoveBetweenFolders = 1U << 13U, kTruncate = 1U << 14U;
constexpr std::uint64_t kNetwork = 3U;  // to listen, and to connect, by TCP
constexpr int kVersionWithMoves = 2, kVersionWithTruncate = 3, kVersionWithNetwork = 4;

constexpr std::uint64_t kReading = kReadFile | kReadFolder;
constexpr std::uint64_t kOfFiles = kExecute | kWriteFile | kReadFile | kTruncate;  // the others are of folders

struct Ruleset {
  std::uint64_t files = 0, network = 0;
};

int landlock_version() {
  return static_cast<int>(syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION));
}

/// All rights that the kernel can restrict.
Ruleset everything(int version) {
  Ruleset rules{kOfFirstVersion, 0};
  if (version >= kVersionWithMoves) rules.files |= kMoveBetweenFolders;
  if (version >= kVersionWithTruncate) rules.files |= kTruncate;
  if (version >= kVersionWithNetwork) rules.network = kNetwork;
  return rules;
}

[[noreturn]] void fail(const char* what) {
  throw Error(fmt::format("lacuna mcp: the kernel's file sandbox cannot be entered: {}: {}", what, strerror(errno)));
}

/// A descriptor that is closed at the end of its scope.
class Handle {
 public:
  explicit Handle(int number) : number_(number) {}
  ~Handle() {
    if (number_ >= 0) close(number_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

/// Missing folders need no rule.
void allow(const Handle& ruleset, const std::filesystem::path& place, std::uint64_t rights) {
  const Handle at(open(place.c_str(), O_PATH | O_CLOEXEC));
  struct stat kind {};
  if (at.number() < 0 || fstat(at.number(), &kind) != 0) return;
  if (!S_ISDIR(kind.st_mode)) rights &= kOfFiles;
  const landlock_path_beneath_attr rule{rights, at.number()};
  if (syscall(SYS_landlock_add_rule, ruleset.number(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) fail(place.c_str());
}

}  // namespace

bool has_file_sandbox() { return landlock_version() > 0; }

void enter_file_sandbox() {
  const int version = files_are_limited() ? landlock_version() : 0;
  if (version <= 0) return;
  const Ruleset rules = everything(version);
  const std::size_t size = version >= kVersionWithNetwork ? sizeof(rules) : sizeof(rules.files);
  const Handle ruleset(static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, size, 0)));
  if (ruleset.number() < 0) fail("rules");
  for (const char* place : {"/usr", "/lib", "/lib64"}) allow(ruleset, place, kReading | kExecute);  // gnuplot
  for (const char* place : {"/etc/ld.so.cache", "/etc/localtime", "/etc/fonts", "/proc", "/sys"})
    allow(ruleset, place, kReading);
  for (const char* place : {"/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom"})
    allow(ruleset, place, kReadFile | kWriteFile);
  for (const std::filesystem::path& folder : AllowedFiles::of_the_program()) allow(ruleset, folder, kReading);
  const AllowedFiles allowed = AllowedFiles::of_this_process();
  for (const std::filesystem::path& folder : allowed.folders()) allow(ruleset, folder, rules.files & ~kExecute);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail("privileges");
  if (syscall(SYS_landlock_restrict_self, ruleset.number(), 0) != 0) fail("restriction");
}

}  // namespace lacuna
