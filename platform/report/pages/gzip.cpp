#include "report/pages/gzip.h"

#include <lacuna/error.h>

#include <zlib.h>

namespace lacuna {

std::vector<std::byte> gzip(std::span<const std::byte> bytes) {
  constexpr int kLevel = 6, kGzipWindow = 15 + 16, kMemory = 8;
  constexpr std::size_t kChunk = std::size_t{1} << 30U;  // zlib counts in 32 bits
  z_stream stream{};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw Error("there is too little memory to compress the report");
  std::vector<std::byte> packed(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64);
  std::size_t in = 0, out = 0;
  for (int result = Z_OK; result != Z_STREAM_END;) {
    const std::size_t give = std::min(kChunk, bytes.size() - in), room = std::min(kChunk, packed.size() - out);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data() + in));
    stream.avail_in = static_cast<uInt>(give);
    stream.next_out = reinterpret_cast<Bytef*>(packed.data() + out);
    stream.avail_out = static_cast<uInt>(room);
    result = deflate(&stream, in + give == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    in += give - stream.avail_in;
    out += room - stream.avail_out;
    if (result == Z_BUF_ERROR || result == Z_STREAM_ERROR) break;
  }
  deflateEnd(&stream);
  packed.resize(out);
  return packed;
}

}  // namespace lacuna
