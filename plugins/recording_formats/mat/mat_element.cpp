#include "mat_element.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace lacuna::mat {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;
constexpr std::uint64_t kAlignment = 8;

std::size_t size_of(MatType type) {
  switch (type) {
    case MatType::int8:
    case MatType::uint8: return 1;
    case MatType::int16:
    case MatType::uint16: return 2;
    case MatType::int32:
    case MatType::uint32:
    case MatType::real32: return 4;
    case MatType::real64:
    case MatType::int64:
    case MatType::uint64: return 8;
    default: return 0;
  }
}

std::uint64_t bits_of(const unsigned char* bytes, std::size_t size, bool is_big_endian) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) bits = bits << 8 | bytes[is_big_endian ? i : size - 1 - i];
  return bits;
}

}  // namespace

MatTag MatReader::read_tag() {
  std::array<unsigned char, 8> bytes{};
  take(bytes.data(), bytes.size());
  const auto first = static_cast<std::uint32_t>(bits_of(bytes.data(), 4, is_big_endian_));
  MatTag tag;
  tag.is_small = first >> 16 != 0;
  tag.type = static_cast<MatType>(tag.is_small ? first & 0xffff : first);
  tag.size = tag.is_small ? first >> 16 : bits_of(bytes.data() + 4, 4, is_big_endian_);
  if (tag.is_small && tag.size > tag.small.size())
    throw BadFile("has a small data element of " + std::to_string(tag.size) + " bytes, but at most 4 are allowed");
  std::copy(bytes.begin() + 4, bytes.end(), tag.small.begin());
  if (!tag.is_small && tag.size > left_)
    throw BadFile("has a data element of " + std::to_string(tag.size) + " bytes where " + std::to_string(left_) +
                  " are left; the file is incomplete or damaged");
  return tag;
}

std::vector<unsigned char> MatReader::read_data(const MatTag& tag, std::size_t most) {
  if (tag.size > most)
    throw BadFile("has " + std::to_string(tag.size) + " bytes of description where at most " + std::to_string(most) +
                  " are allowed");
  if (tag.is_small) return {tag.small.begin(), tag.small.begin() + static_cast<std::ptrdiff_t>(tag.size)};
  std::vector<unsigned char> data(static_cast<std::size_t>(tag.size));
  take(data.data(), data.size());
  skip_padding(tag);
  return data;
}

void MatReader::skip_data(const MatTag& tag) {
  if (tag.is_small) return;
  skip(tag.size);
  skip_padding(tag);
}

std::uint64_t MatReader::count_of(const MatTag& tag) {
  const std::size_t size = size_of(tag.type);
  return size == 0 ? 0 : tag.size / size;
}

void MatReader::read_numbers(const MatTag& tag, const std::function<void(std::uint64_t, LongNumber)>& number) {
  const std::size_t size = size_of(tag.type);
  if (size == 0) return skip_data(tag);
  if (tag.is_small) {
    for (std::uint64_t i = 0; i < count_of(tag); ++i) number(i, number_of(tag.small.data() + i * size, tag.type));
    return;
  }
  std::vector<unsigned char> piece(kPiece);
  for (std::uint64_t done = 0; done < count_of(tag);) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kPiece / size, count_of(tag) - done));
    take(piece.data(), count * size);
    for (std::size_t i = 0; i < count; ++i) number(done + i, number_of(piece.data() + i * size, tag.type));
    done += count;
  }
  skip(tag.size % size);
  skip_padding(tag);
}

std::uint64_t MatReader::number_at(const std::vector<unsigned char>& data, std::size_t place) const {
  if (place + 4 > data.size()) throw BadFile("has too few bytes for the description of a variable");
  return bits_of(data.data() + place, 4, is_big_endian_);
}

void MatReader::take(unsigned char* into, std::size_t count) {
  if (count > left_ || stream_.read(into, count) < count) throw BadFile("ends within a variable; copy the file again");
  left_ -= count;
}

void MatReader::skip(std::uint64_t count) {
  std::vector<unsigned char> piece(static_cast<std::size_t>(std::min<std::uint64_t>(count, kPiece)));
  while (count > 0) {
    const auto now = static_cast<std::size_t>(std::min<std::uint64_t>(count, piece.size()));
    take(piece.data(), now);
    count -= now;
  }
}

/// Elements begin at multiples of 8 bytes; missing padding at the very end does not matter.
void MatReader::skip_padding(const MatTag& tag) {
  const std::uint64_t padding = (kAlignment - tag.size % kAlignment) % kAlignment;
  skip(std::min(padding, left_));
}

LongNumber MatReader::number_of(const unsigned char* bytes, MatType type) const {
  const std::size_t size = size_of(type);
  const std::uint64_t bits = bits_of(bytes, size, is_big_endian_);
  switch (type) {
    case MatType::real32: return {0, static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))};
    case MatType::real64: return {0, std::bit_cast<double>(bits)};
    case MatType::int8: return {static_cast<std::int8_t>(bits), 0.0};
    case MatType::int16: return {static_cast<std::int16_t>(bits), 0.0};
    case MatType::int32: return {static_cast<std::int32_t>(bits), 0.0};
    case MatType::int64: return {static_cast<std::int64_t>(bits), 0.0};
    default: break;
  }
  if (bits > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    return {0, static_cast<double>(bits)};
  return {static_cast<std::int64_t>(bits), 0.0};
}

}  // namespace lacuna::mat
