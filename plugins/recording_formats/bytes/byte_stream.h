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

/// Why a file is unusable: where, what, and what to do.
class BadFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file with random access. Throws `BadFile` where that is impossible.
class RandomFile {
 public:
  explicit RandomFile(const std::string& path);

  std::uint64_t size() const { return size_; }
  /// The bytes at that position, at most `count`.
  std::size_t read_at(std::uint64_t place, unsigned char* into, std::size_t count);

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file_;
  std::uint64_t size_ = 0, place_ = 0;
};

/// Compression of a file's bytes.
enum class Packing {
  none,
  deflate,  ///< like members of a ZIP archive (RFC 1951)
  zlib      ///< the same with a header and a checksum (RFC 1950)
};

/// A sequence of bytes: a part of a file, or its decompressed content.
class ByteStream {
 public:
  /// The file outlives the stream.
  ByteStream(RandomFile& file, std::uint64_t place, std::uint64_t size, Packing packing);
  ~ByteStream();
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  /// The next bytes, at most `count`. Throws `BadFile` for damaged compressed data.
  std::size_t read(unsigned char* into, std::size_t count);
  /// CRC-32 of all bytes read.
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
