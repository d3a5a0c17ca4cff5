#include "message_pack.h"

#include "bad_bag.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <string>

namespace lacuna::rosbag2 {
namespace {

constexpr std::size_t kUnpackedPiece = std::size_t{1} << 18;
constexpr std::array<unsigned char, 4> kZstdSign = {0x28, 0xb5, 0x2f, 0xfd};

[[noreturn]] void throw_damaged(const char* compression) {
  throw BadBag(std::string("is damaged: data compressed with ") + compression + " cannot be unpacked");
}

}  // namespace

struct MessagePack::Contexts {
  ~Contexts() {
    ZSTD_freeDStream(zstd);
    LZ4F_freeDecompressionContext(lz4);
  }
  ZSTD_DStream* zstd = nullptr;
  LZ4F_dctx* lz4 = nullptr;
};

MessagePack::MessagePack() : contexts_(std::make_unique<Contexts>()) {}
MessagePack::~MessagePack() = default;

Bytes MessagePack::unpack(Bytes message) {
  const bool is_packed =
      message.size() >= kZstdSign.size() && std::equal(kZstdSign.begin(), kZstdSign.end(), message.begin());
  return is_packed ? unpack_zstd(message) : message;
}

Bytes MessagePack::unpack(Bytes packed, std::string_view compression) {
  if (compression.empty()) return packed;
  if (compression == "zstd") return unpack_zstd(packed);
  if (compression == "lz4") return unpack_lz4(packed);
  throw BadBag("is compressed with \"" + std::string(compression.substr(0, 40)) + "\"; only zstd and lz4 can be read");
}

/// Memory is allocated only for data that were really decompressed.
void MessagePack::grow() {
  if (unpacked_.size() >= kLargest) throw BadBag("contains more than 256 MiB in one piece; write it in smaller chunks");
  unpacked_.resize(std::max(kUnpackedPiece, 2 * unpacked_.size()));
}

Bytes MessagePack::unpack_zstd(Bytes packed) {
  if (!contexts_->zstd) contexts_->zstd = ZSTD_createDStream();
  ZSTD_initDStream(contexts_->zstd);
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  std::size_t filled = 0, left = 1;
  while (left != 0 || in.pos < in.size) {
    if (filled == unpacked_.size()) grow();
    ZSTD_outBuffer out{unpacked_.data(), unpacked_.size(), filled};
    const std::size_t before = in.pos;
    left = ZSTD_decompressStream(contexts_->zstd, &out, &in);
    if (ZSTD_isError(left) != 0 || (out.pos == filled && in.pos == before)) throw_damaged("zstd");
    filled = out.pos;
  }
  return {unpacked_.data(), filled};
}

Bytes MessagePack::unpack_lz4(Bytes packed) {
  if (!contexts_->lz4 && LZ4F_isError(LZ4F_createDecompressionContext(&contexts_->lz4, LZ4F_VERSION)) != 0)
    throw BadBag("cannot be decompressed: not enough memory");
  LZ4F_resetDecompressionContext(contexts_->lz4);
  std::size_t filled = 0, place = 0, left = 1;
  while (left != 0 || place < packed.size()) {
    if (filled == unpacked_.size()) grow();
    std::size_t out = unpacked_.size() - filled, in = packed.size() - place;
    left = LZ4F_decompress(contexts_->lz4, unpacked_.data() + filled, &out, packed.data() + place, &in, nullptr);
    if (LZ4F_isError(left) != 0 || (out == 0 && in == 0)) throw_damaged("lz4");
    filled += out;
    place += in;
  }
  return {unpacked_.data(), filled};
}

}  // namespace lacuna::rosbag2
