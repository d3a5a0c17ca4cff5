#pragma once

#include <cstddef>
#include <string>

namespace lacuna {

/// Reads lines from a pipe, as they come, without holding more of one than its limit.
class MessageLines {
 public:
  enum class Got { nothing, line, too_long, end };

  /// `longest`: bytes that a line may have.
  MessageLines(int descriptor, std::size_t longest) : descriptor_(descriptor), longest_(longest) {}

  /// Waits for at most `milliseconds`. `line`: what came, without its newline. A line that is too long is skipped and
  /// told once. What stands behind the last newline when the input ends is a line. Throws `Error` where nothing can be
  /// read.
  Got next(std::string& line, int milliseconds);

 private:
  Got take(std::string& line);
  bool read_some(int milliseconds);

  int descriptor_;
  std::size_t longest_;
  std::string received_;
  std::size_t searched_ = 0;  ///< so many bytes of `received_` have no newline
  bool skipping_ = false;     ///< the rest of a line that was too long
  bool ended_ = false;
};

}  // namespace lacuna
