#include "app/terminal/replace_file.h"

#include <lacuna/error.h>

#include "foundation/text/problem.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace lacuna {
namespace {

/// A new name in a folder outlives a power cut only when the folder is on the disk.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw Error(file.string() + ": cannot be read; check that it exists, and its permissions");
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

TextReplacement::TextReplacement(const std::filesystem::path& file, std::string old_text, std::string new_text)
    : file_(file),
      old_text_(std::move(old_text)),
      new_text_(std::move(new_text)),
      new_(file, Link::followed),
      old_(file, Link::followed) {
  new_.stream() << new_text_;
  new_.finish();
  old_.stream() << old_text_;
  old_.finish();
}

void TextReplacement::publish() {
  if (read_text(file_) != old_text_)
    throw Error(file_.string() +
                ": was changed by another program during this command; nothing was written, run the command again");
  new_.publish();
  published_ = true;
  sync_folder(std::filesystem::canonical(file_).parent_path());
}

void TextReplacement::take_back() {
  if (!published_ || read_text(file_) != new_text_) return;
  old_.publish();
  published_ = false;
}

}  // namespace lacuna
