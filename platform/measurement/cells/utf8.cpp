#include "measurement/cells/utf8.h"

namespace lacuna {
namespace {

/// Bytes that must follow a first byte; -1 where it cannot be one.
int following_bytes(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xc2 && first < 0xe0) return 1;
  if (first >= 0xe0 && first < 0xf0) return 2;
  return first >= 0xf0 && first < 0xf5 ? 3 : -1;
}

void append_utf8(char32_t character, std::string& text) {
  const auto rest = [&](int shift) { text += static_cast<char>(0x80 | ((character >> shift) & 0x3f)); };
  if (character < 0x80) {
    text += static_cast<char>(character);
  } else if (character < 0x800) {
    text += static_cast<char>(0xc0 | (character >> 6));
    rest(0);
  } else if (character < 0x10000) {
    text += static_cast<char>(0xe0 | (character >> 12));
    rest(6);
    rest(0);
  } else {
    text += static_cast<char>(0xf0 | (character >> 18));
    rest(12);
    rest(6);
    rest(0);
  }
}

/// Two bytes each.
class Utf16Units {
 public:
  Utf16Units(std::string_view bytes, Utf16 order) : bytes_(bytes), high_(order == Utf16::big_endian ? 0 : 1) {}
  std::size_t size() const { return bytes_.size() / 2; }
  char32_t operator[](std::size_t i) const {
    const auto byte = [&](std::size_t at) { return static_cast<char32_t>(static_cast<unsigned char>(bytes_[at])); };
    return (byte(2 * i + high_) << 8) | byte(2 * i + 1 - high_);
  }

 private:
  std::string_view bytes_;
  std::size_t high_;
};

}  // namespace

std::optional<Utf16> utf16_in(std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe")) return Utf16::little_endian;
  if (bytes.starts_with("\xfe\xff")) return Utf16::big_endian;
  constexpr std::size_t kHead = 4096, kFewest = 8;
  const std::string_view head = bytes.substr(0, kHead);
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < head.size(); ++i) zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  if (head.size() < kFewest || (zeros[0] + zeros[1]) * 5 < head.size() * 2) return std::nullopt;
  if (zeros[0] == 0) return Utf16::little_endian;
  return zeros[1] == 0 ? std::optional(Utf16::big_endian) : std::nullopt;
}

std::string utf8_from_utf16(std::string_view bytes, Utf16 order) {
  constexpr char32_t kMark = 0xfeff, kNone = 0xfffd;
  const Utf16Units units(bytes, order);
  std::string text;
  text.reserve(units.size());
  const auto is_high = [](char32_t unit) { return unit >= 0xd800 && unit < 0xdc00; };
  const auto is_low = [](char32_t unit) { return unit >= 0xdc00 && unit < 0xe000; };
  for (std::size_t i = units.size() > 0 && units[0] == kMark ? 1 : 0; i < units.size(); ++i) {
    const char32_t unit = units[i];
    if (is_high(unit) && i + 1 < units.size() && is_low(units[i + 1]))
      append_utf8(0x10000 + ((unit - 0xd800) << 10) + (units[++i] - 0xdc00), text);
    else
      append_utf8(is_high(unit) || is_low(unit) ? kNone : unit, text);
  }
  return text;
}

bool is_utf8(std::string_view text) {
  int expected = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool follows = (byte & 0xc0) == 0x80;
    if ((expected > 0) != follows) return false;
    expected = follows ? expected - 1 : following_bytes(byte);
    if (expected < 0) return false;
  }
  return expected == 0;
}

std::string utf8_from_latin1(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xc0 | (byte >> 6));
      result += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return result;
}

}  // namespace lacuna
