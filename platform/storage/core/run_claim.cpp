#include "storage/core/run_claim.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>
#include <utility>

namespace lacuna {
namespace {

std::string name_of(const Database& database, RunId run) {
  struct stat file {};
  stat(database.file().c_str(), &file);
  return "lacuna run " + std::to_string(file.st_dev) + " " + std::to_string(file.st_ino) + " " +
         std::to_string(run.value);
}

}  // namespace

RunClaim::RunClaim(const Database& database, RunId run) : socket_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = name_of(database, run);
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // a zero byte first: the abstract namespace
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  const bool taken = bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) != 0 && errno == EADDRINUSE;
  held_ = !taken;
}

RunClaim::~RunClaim() {
  if (socket_ >= 0) close(socket_);
}

RunClaim::RunClaim(RunClaim&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), held_(std::exchange(other.held_, false)) {}

}  // namespace lacuna
