#include "cdr_reader.h"

#include "bad_bag.h"

#include <algorithm>
#include <bit>
#include <string>

namespace lacuna::rosbag2 {
namespace {

constexpr std::size_t kEncapsulation = 4;  ///< bytes
constexpr std::size_t kMostPadding = 3;    ///< padding bytes after a message

LongNumber number_of(std::uint64_t bits, Primitive primitive) {
  switch (primitive) {
    case Primitive::int8: return {static_cast<std::int8_t>(bits), 0.0};
    case Primitive::int16: return {static_cast<std::int16_t>(bits), 0.0};
    case Primitive::int32: return {static_cast<std::int32_t>(bits), 0.0};
    case Primitive::int64: return {static_cast<std::int64_t>(bits), 0.0};
    case Primitive::float32: return {0, static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))};
    case Primitive::float64: return {0, std::bit_cast<double>(bits)};
    default: break;
  }
  if (bits > std::uint64_t{1} << 62) return {0, static_cast<double>(bits)};
  return {static_cast<std::int64_t>(bits), 0.0};
}

}  // namespace

void CdrReader::read(Bytes message, const MessageTypes& types, ValueTree& tree) {
  types_ = &types;
  bytes_ = message;
  place_ = 0;
  tree.clear();
  read_encapsulation();
  tree.begin(ValueTree::Kind::object, {});
  read_message(0, &tree);
  tree.end();
  if (bytes_.size() - place_ > kMostPadding)
    throw BadBag("has " + std::to_string(bytes_.size()) + " bytes, but its type needs " + std::to_string(place_));
}

/// Two bytes for the encoding, two for options.
void CdrReader::read_encapsulation() {
  if (bytes_.size() < kEncapsulation) throw BadBag("has no beginning (the encapsulation of CDR)");
  const unsigned encoding = static_cast<unsigned>(bytes_[0]) << 8 | bytes_[1];
  const bool is_first = encoding == 0x0000 || encoding == 0x0001, is_second = encoding == 0x0006 || encoding == 0x0007;
  if (!is_first && !is_second)
    throw BadBag("has the encapsulation " + std::to_string(encoding) + ", which is not plain CDR");
  is_big_endian_ = (encoding & 1U) == 0;
  widest_ = is_first ? 8 : 4;
  bytes_ = bytes_.subspan(kEncapsulation);
}

/// A type without fields has one unused byte.
void CdrReader::read_message(std::size_t type, ValueTree* tree) {
  const std::vector<MessageField>& fields = types_->types[type].fields;
  if (fields.empty()) read_bits(1);
  for (const MessageField& field : fields) read_field(field, tree);
}

void CdrReader::read_field(const MessageField& field, ValueTree* tree) {
  if (field.times == Times::once) return read_once(field, field.name, tree);
  const std::size_t count = field.times == Times::fixed ? field.count : read_count();
  need(count);  // each takes at least one byte
  if (count > NumberPaths::kMostElements) return read_list(field, count, nullptr);
  if (tree) tree->begin(ValueTree::Kind::list, field.name);
  read_list(field, count, tree);
  if (tree) tree->end();
}

void CdrReader::read_list(const MessageField& field, std::size_t count, ValueTree* tree) {
  const bool is_skipped = !tree && field.primitive != Primitive::none && field.primitive != Primitive::text;
  if (!is_skipped) {
    for (std::size_t i = 0; i < count; ++i) read_once(field, {}, tree);
    return;
  }
  const std::size_t size = size_of(field.primitive);
  align(size);
  need(static_cast<std::uint64_t>(count) * size);
  place_ += count * size;
}

void CdrReader::read_once(const MessageField& field, std::string_view key, ValueTree* tree) {
  if (field.primitive == Primitive::text) {
    const std::string_view text = read_text();
    if (tree) tree->add_text(key, text);
  } else if (field.primitive != Primitive::none) {
    const LongNumber number = number_of(read_bits(size_of(field.primitive)), field.primitive);
    if (tree) tree->add_number(key, number);
  } else {
    if (tree) tree->begin(ValueTree::Kind::object, key);
    read_message(field.type, tree);
    if (tree) tree->end();
  }
}

/// A count of bytes including the zero that ends the text.
std::string_view CdrReader::read_text() {
  const std::uint32_t length = read_count();
  need(length);
  const auto* const start = reinterpret_cast<const char*>(bytes_.data()) + place_;
  place_ += length;
  if (length == 0) return {};
  if (start[length - 1] != '\0') throw BadBag("has a text without an end at byte " + std::to_string(place_));
  return {start, length - 1};
}

std::uint64_t CdrReader::read_bits(std::size_t size) {
  align(size);
  need(size);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) bits = bits << 8 | bytes_[place_ + (is_big_endian_ ? i : size - 1 - i)];
  place_ += size;
  return bits;
}

std::uint32_t CdrReader::read_count() { return static_cast<std::uint32_t>(read_bits(4)); }

void CdrReader::align(std::size_t size) {
  const std::size_t to = std::min(size, widest_);
  place_ = std::min((place_ + to - 1) / to * to, bytes_.size());
}

void CdrReader::need(std::uint64_t size) const {
  if (size > bytes_.size() - place_)
    throw BadBag("is too short for its type, at byte " + std::to_string(bytes_.size()));
}

}  // namespace lacuna::rosbag2
