#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace lacuna::recording_bytes {

/// What makes a file unusable: where, what, and what to do.
class BadFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that is read from any place. Throws `BadFile` where it cannot be.
class RandomFile {
 public:
  explicit RandomFile(const std::string& path);

  std::uint64_t size() const { return size_; }
  /// As many bytes as there are at that place, at most `count`.
  std::size_t read_at(std::uint64_t place, unsigned char* into, std::size_t count);

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file_;
  std::uint64_t size_ = 0, place_ = 0;
};

/// How bytes of a file are packed.
enum class Packing {
  none,
  deflate,  ///< as members of a ZIP archive are (RFC 1951)
  zlib      ///< the same with a head and a checksum (RFC 1950)
};

/// Bytes one after another: a part of a file as it is, or what it is when inflated.
class ByteStream {
 public:
  /// The file outlives the stream.
  ByteStream(RandomFile& file, std::uint64_t place, std::uint64_t size, Packing packing);
  ~ByteStream();
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// As many bytes as there are, at most `count`. Throws `BadFile` for packed data that are damaged.
  std::size_t read(unsigned char* into, std::size_t count);
  /// CRC-32 of all that was read.
  std::uint32_t checksum() const { return checksum_; }

 private:
  std::size_t read_stored(unsigned char* into, std::size_t count);
  std::size_t inflate_some(unsigned char* into, std::size_t count);

  RandomFile& file_;
  std::uint64_t place_, left_;
  bool is_packed_, ended_ = false;
  std::uint32_t checksum_ = 0;
  z_stream inflater_ = {};
  std::vector<unsigned char> packed_;
};

}  // namespace lacuna::recording_bytes
