#include "line_file.h"

#include <cerrno>
#include <cstring>

namespace lacuna::json_lines {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 18;

}  // namespace

LineFile::LineFile(const std::string& path) : file_(std::fopen(path.c_str(), "rb")) {
  if (!file_) fault_ = std::string("cannot be opened: ") + std::strerror(errno);
}

/// Continues reading; false at the end, or where a line is too long.
bool LineFile::fill() {
  if (ended_) return false;
  if (start_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + start_, filled_ - start_);
    filled_ -= start_;
    start_ = 0;
  }
  if (filled_ > kLongestLine) {
    fault_ =
        "line " + std::to_string(number_ + 1) + " is longer than 16 MiB: write one object per line, with one sample";
    return false;
  }
  if (buffer_.size() < filled_ + kPiece) buffer_.resize(filled_ + kPiece);
  const std::size_t got = std::fread(buffer_.data() + filled_, 1, kPiece, file_.get());
  filled_ += got;
  if (got == 0) ended_ = true;
  if (got == 0 && std::ferror(file_.get())) fault_ = std::string("cannot be read completely: ") + std::strerror(errno);
  return got > 0;
}

bool LineFile::next(std::string_view& line) {
  if (!file_ || !fault_.empty()) return false;
  std::size_t searched = start_;
  const char* end = nullptr;
  while (!(end = static_cast<const char*>(std::memchr(buffer_.data() + searched, '\n', filled_ - searched)))) {
    const std::size_t known = filled_ - start_;
    if (!fill()) break;
    searched = start_ + known;
  }
  if (!fault_.empty() || (!end && start_ == filled_)) return false;
  cut_ = end == nullptr;
  const std::size_t length = cut_ ? filled_ - start_ : static_cast<std::size_t>(end - buffer_.data()) - start_;
  line = std::string_view(buffer_).substr(start_, length);
  start_ += length + (cut_ ? 0 : 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (++number_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
  return true;
}

}  // namespace lacuna::json_lines
