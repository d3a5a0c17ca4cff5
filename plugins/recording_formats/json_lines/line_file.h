#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace lacuna::json_lines {

/// The lines of a file, one after another. Only one of them and a piece of the file are in memory.
class LineFile {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{16} << 20;

  explicit LineFile(const std::string& path);

  /// False at the end of the file, or where it cannot be read: then `fault` is not empty. The view is valid until the
  /// next call. Lines end in \n or \r\n.
  bool next(std::string_view& line);
  int number() const { return number_; }    ///< number of the line just read, from 1
  bool at_cut_end() const { return cut_; }  ///< the line just read ended with the file
  const std::string& fault() const { return fault_; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  bool fill();

  std::unique_ptr<std::FILE, Closer> file_;
  std::string buffer_;
  std::size_t start_ = 0, filled_ = 0;  ///< of the unread part of the buffer
  int number_ = 0;
  bool cut_ = false, ended_ = false;
  std::string fault_;
};

}  // namespace lacuna::json_lines
