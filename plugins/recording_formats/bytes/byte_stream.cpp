#include "byte_stream.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace lacuna::recording_bytes {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;

}  // namespace

RandomFile::RandomFile(const std::string& path) : file_(std::fopen(path.c_str(), "rb")) {
  if (!file_) throw BadFile(std::string("cannot be opened: ") + std::strerror(errno));
  if (::fseeko(file_.get(), 0, SEEK_END) != 0)
    throw BadFile("is not a file that can be read from any position; name a file");
  size_ = place_ = static_cast<std::uint64_t>(::ftello(file_.get()));
}

std::size_t RandomFile::read_at(std::uint64_t place, unsigned char* into, std::size_t count) {
  if (place >= size_) return 0;
  count = static_cast<std::size_t>(std::min<std::uint64_t>(count, size_ - place));
  if (place != place_ && ::fseeko(file_.get(), static_cast<off_t>(place), SEEK_SET) != 0)
    throw BadFile(std::string("cannot be read: ") + std::strerror(errno));
  const std::size_t got = std::fread(into, 1, count, file_.get());
  if (got < count && std::ferror(file_.get()))
    throw BadFile(std::string("cannot be read completely: ") + std::strerror(errno));
  place_ = place + got;
  return got;
}

ByteStream::ByteStream(RandomFile& file, std::uint64_t place, std::uint64_t size, Packing packing)
    : file_(file), place_(place), left_(size), is_packed_(packing != Packing::none) {
  if (!is_packed_) return;
  packed_.resize(kPiece);
  if (inflateInit2(&inflater_, packing == Packing::deflate ? -MAX_WBITS : MAX_WBITS) != Z_OK)
    throw BadFile("cannot be decompressed: not enough memory");
}

ByteStream::~ByteStream() {
  if (is_packed_) inflateEnd(&inflater_);
}

std::size_t ByteStream::read(unsigned char* into, std::size_t count) {
  std::size_t filled = 0;
  while (filled < count) {
    const std::size_t got =
        is_packed_ ? inflate_some(into + filled, count - filled) : read_stored(into + filled, count - filled);
    if (got == 0) break;
    filled += got;
  }
  checksum_ = static_cast<std::uint32_t>(crc32_z(checksum_, into, filled));
  return filled;
}

std::size_t ByteStream::read_stored(unsigned char* into, std::size_t count) {
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(count, left_));
  const std::size_t got = file_.read_at(place_, into, wanted);
  place_ += got;
  left_ -= got;
  return got;
}

std::size_t ByteStream::inflate_some(unsigned char* into, std::size_t count) {
  const auto wanted = static_cast<uInt>(std::min<std::size_t>(count, std::size_t{1} << 30));
  inflater_.next_out = into;
  inflater_.avail_out = wanted;
  while (inflater_.avail_out == wanted && !ended_) {
    if (inflater_.avail_in == 0) {
      inflater_.avail_in = static_cast<uInt>(read_stored(packed_.data(), packed_.size()));
      inflater_.next_in = packed_.data();
      if (inflater_.avail_in == 0) break;
    }
    const int result = inflate(&inflater_, Z_NO_FLUSH);
    if (result == Z_STREAM_END)
      ended_ = true;
    else if (result != Z_OK && result != Z_BUF_ERROR)
      throw BadFile("its compressed data are damaged; copy the file again or record it anew");
  }
  return wanted - inflater_.avail_out;
}

}  // namespace lacuna::recording_bytes
