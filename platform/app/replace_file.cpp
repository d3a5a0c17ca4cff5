#include "app/replace_file.h"

#include <lacuna/error.h>

#include "foundation/problem.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace lacuna {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

bool write_all(int descriptor, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    written += static_cast<std::size_t>(count);
  }
  return ::fsync(descriptor) == 0;
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& draft) {
  const std::string reason = std::strerror(errno);
  if (!draft.empty()) ::unlink(draft.c_str());
  throw Error(file.string() + ": cannot be changed (" + reason + "); it is as it was");
}

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw Error(file.string() + ": cannot be read; check that the file exists and its permissions");
  return text;
}

void check_replaceable(const std::filesystem::path& file) {
  std::error_code failure;
  const std::filesystem::path real = std::filesystem::canonical(file, failure);
  if (failure) return;  // reading it says more
  if (::access(real.c_str(), W_OK) != 0 || ::access(real.parent_path().c_str(), W_OK) != 0)
    throw_problem({file.string(), 0, 0}, std::string("may not be changed (") + std::strerror(errno) +
                                             "); check the permissions of the file and of its folder");
}

void replace_text(const std::filesystem::path& file, const std::string& expected, const std::string& text) {
  const std::filesystem::path real = std::filesystem::canonical(file);
  if (read_text(real) != expected)
    throw Error(file.string() + ": was changed by someone else meanwhile; nothing was written, run the command again");
  struct stat status {};
  if (::stat(real.c_str(), &status) != 0) fail(file, "");
  if (::access(real.c_str(), W_OK) != 0) fail(file, "");
  std::string draft = real.string() + ".XXXXXX";
  const Descriptor descriptor(::mkstemp(draft.data()));
  if (descriptor.number() < 0) fail(file, "");
  if (!write_all(descriptor.number(), text) || ::fchmod(descriptor.number(), status.st_mode & 07777U) != 0 ||
      ::rename(draft.c_str(), real.c_str()) != 0)
    fail(file, draft);
  const Descriptor folder(::open(real.parent_path().c_str(), O_RDONLY | O_DIRECTORY));
  if (folder.number() >= 0) ::fsync(folder.number());
}

}  // namespace lacuna
