#include "storage/core/run_claim.h"

#include "storage/core/statement.h"

#include <lacuna/error.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace lacuna {
namespace {

/// Processes with the same see each other's sockets.
const std::string& this_machine() {
  static const std::string machine = [] {
    std::string boot;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
    std::error_code unknown;
    return boot + " " + std::filesystem::read_symlink("/proc/self/ns/net", unknown).string();
  }();
  return machine;
}

/// No other process has ever the same.
const std::string& this_process() {
  static const std::string process = this_machine() + " " + std::to_string(getpid()) + " " +
                                     std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
  return process;
}

struct stat identity_of(const Database& database) {
  struct stat file {};
  stat(database.file().c_str(), &file);
  return file;
}

/// Of the file, on whatever machine it is seen from; a copy has another.
std::int64_t inode_of(const Database& database) { return static_cast<std::int64_t>(identity_of(database).st_ino); }

std::string name_of(const Database& database, RunId run) {
  const struct stat file = identity_of(database);
  return "lacuna run " + std::to_string(file.st_dev) + " " + std::to_string(file.st_ino) + " " +
         std::to_string(run.value);
}

/// False: another process has the name.
bool take_name(int socket, const std::string& name) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // a zero byte first: the abstract namespace
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  return bind(socket, reinterpret_cast<const sockaddr*>(&address), size) == 0 || errno != EADDRINUSE;
}

/// False: another machine has the row. Who has the name finds rows of this machine left by processes that have ended.
bool take_row(Database& database, RunId run, const std::vector<ForeignClaim>& silent) {
  Transaction transaction(database);
  for (const ForeignClaim& foreign : foreign_claims(database)) {
    if (foreign.run.value != run.value) continue;
    if (std::find(silent.begin(), silent.end(), foreign) == silent.end()) return false;
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
    : database_(&database), run_(run), socket_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  held_ = take_name(socket_, name_of(database, run)) && take_row(database, run, silent);
}

RunClaim::~RunClaim() {
  if (held_) try {
      Transaction transaction(*database_);
      Statement(*database_, "DELETE FROM claim WHERE run = ? AND holder = ?").run_with(run_, this_process());
      transaction.commit();
    } catch (const std::exception&) {
      // The row falls silent with this process.
    }
  if (socket_ >= 0) close(socket_);
}

RunClaim::RunClaim(RunClaim&& other) noexcept
    : database_(other.database_),
      run_(other.run_),
      socket_(std::exchange(other.socket_, -1)),
      held_(std::exchange(other.held_, false)) {}

void beat_claims(Database& database) {
  Transaction transaction(database);
  Statement(database, "UPDATE claim SET beat = beat + 1 WHERE holder = ?").run_with(this_process());
  transaction.commit();
}

void check_claim(const Database& database, RunId run) {
  Statement found(database, "SELECT holder FROM claim WHERE run = ? AND file = ?");
  if (found.with(run, inode_of(database)).step() && found.text(0) != this_process())
    throw Error(database.file().string() + ": run " + std::to_string(run.value) +
                " is being continued by another process, too; this one stops, and nothing stored is lost");
}

}  // namespace lacuna
