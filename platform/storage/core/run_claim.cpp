#include "storage/core/run_claim.h"

#include "storage/core/statement.h"

#include <lacuna/error.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <utility>

namespace lacuna {
namespace {

/// Processes with the same see each other's names.
const std::string& this_machine() {
  static const std::string machine = [] {
    std::string boot;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
    std::error_code unknown;
    return boot + " " + std::filesystem::read_symlink("/proc/self/ns/net", unknown).string();
  }();
  return machine;
}

/// No other process has ever the same, be it forked from this one.
std::string this_process() {
  static std::mutex guard;
  static pid_t owner = 0;
  static std::string process;
  const std::lock_guard lock(guard);
  if (owner != getpid()) {
    owner = getpid();
    process = this_machine() + " " + std::to_string(owner) + " " +
              std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
  }
  return process;
}

/// Of the file, on whatever machine it is seen from; a copy has another.
std::int64_t inode_of(const Database& database) {
  struct stat file {};
  stat(database.file().c_str(), &file);
  return static_cast<std::int64_t>(file.st_ino);
}

/// A name in Linux's abstract namespace, which the kernel takes away with the process that has it. False: another one
/// has it.
bool bind_name(int socket, const std::string& holder) {
  const std::string name = "lacuna " + holder;
  sockaddr_un address{};
  if (name.size() + 1 > sizeof(address.sun_path)) throw Error(name + ": is too long as the name of a socket");
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // a zero byte first: the abstract namespace
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(socket, reinterpret_cast<const sockaddr*>(&address), size) == 0) return true;
  if (errno == EADDRINUSE) return false;
  throw Error(std::string("the process cannot tell other processes that it is running: ") + std::strerror(errno));
}

int open_socket() {
  const int descriptor = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0)
    throw Error(std::string("the process cannot tell other processes that it is running: ") + std::strerror(errno));
  return descriptor;
}

/// From now on other processes of this machine see that this one lives.
void show_life() {
  static std::atomic<pid_t> shown = 0;
  if (shown.exchange(getpid()) != getpid()) bind_name(open_socket(), this_process());  // open until the process ends
}

bool lives(const std::string& holder) {
  if (holder == this_process()) return true;
  const int probe = open_socket();
  const bool is_free = bind_name(probe, holder);
  close(probe);
  return !is_free;
}

/// Whether a claim counts: `machine` and `holder` as its row has them.
bool counts(const std::string& machine, const ForeignClaim& claim, const std::vector<ForeignClaim>& silent) {
  if (machine == this_machine()) return lives(claim.holder);
  return std::find(silent.begin(), silent.end(), claim) == silent.end();
}

/// False: another process has the row.
bool take_row(Database& database, RunId run, const std::vector<ForeignClaim>& silent) {
  Transaction transaction(database);
  {
    Statement found(database, "SELECT machine, holder, beat FROM claim WHERE run = ? AND file = ?");
    found.with(run, inode_of(database));
    while (found.step())
      if (counts(found.text(0), {run, found.text(1), found.integer(2)}, silent)) return false;
  }
  Statement(database, "INSERT OR REPLACE INTO claim (run, machine, holder, file, beat) VALUES (?, ?, ?, ?, 0)")
      .run_with(run, this_machine(), this_process(), inode_of(database));
  transaction.commit();
  return true;
}

}  // namespace

std::vector<ForeignClaim> foreign_claims(const Database& database) {
  Statement found(database, "SELECT run, holder, beat FROM claim WHERE machine <> ? AND file = ?");
  found.with(this_machine(), inode_of(database));
  std::vector<ForeignClaim> claims;
  while (found.step()) claims.push_back({RunId{found.integer(0)}, found.text(1), found.integer(2)});
  return claims;
}

RunClaim::RunClaim(Database& database, RunId run, const std::vector<ForeignClaim>& silent)
    : database_(&database), run_(run) {
  show_life();
  held_ = take_row(database, run, silent);
}

void RunClaim::remove_row() {
  Statement(*database_, "DELETE FROM claim WHERE run = ? AND holder = ?").run_with(run_, this_process());
}

void RunClaim::release(std::vector<RunClaim>& claims) {
  if (claims.empty()) return;
  try {
    Transaction transaction(*claims.front().database_);
    for (RunClaim& claim : claims)
      if (claim.held_) claim.remove_row();
    transaction.commit();
  } catch (const std::exception&) {
    // The rows fall silent with this process.
  }
  for (RunClaim& claim : claims) claim.held_ = false;
}

RunClaim::~RunClaim() {
  if (!held_) return;
  try {
    Transaction transaction(*database_);
    remove_row();
    transaction.commit();
  } catch (const std::exception&) {
    // The row falls silent with this process.
  }
}

RunClaim::RunClaim(RunClaim&& other) noexcept
    : database_(other.database_), run_(other.run_), held_(std::exchange(other.held_, false)) {}

std::vector<ForeignClaim> silent_claims(const Database& database, const std::vector<RunId>& runs,
                                        const std::function<void()>& before_waiting) {
  std::vector<ForeignClaim> claims = foreign_claims(database);
  std::erase_if(claims, [&](const ForeignClaim& claim) {
    return std::none_of(runs.begin(), runs.end(), [&](const RunId run) { return run.value == claim.run.value; });
  });
  if (claims.empty()) return claims;
  if (before_waiting) before_waiting();
  database.stop().pause_for(kSilence);
  return claims;  // one that has beaten since is another
}

void beat_claims(Database& database) {
  Transaction transaction(database);
  Statement(database, "UPDATE claim SET beat = beat + 1 WHERE holder = ?").run_with(this_process());
  transaction.commit();
}

bool is_taken_over(const Database& database, RunId run) {
  Statement found(database, "SELECT holder FROM claim WHERE run = ? AND file = ?");
  return found.with(run, inode_of(database)).step() && found.text(0) != this_process();
}

void check_claim(const Database& database, RunId run) {
  if (is_taken_over(database, run))
    throw Error(database.file().string() + ": run " + std::to_string(run.value) +
                " is also continued by another process; this process stops, and nothing stored is lost");
}

}  // namespace lacuna
