#pragma once

#include <cstdint>
#include <string>

namespace lacuna {

/// The bytes of an MCAP file, record by record, without any summary.
class McapBytes {
 public:
  McapBytes() { record('\x01', text("") + text("")); }

  void schema(std::uint16_t id, const std::string& name, const std::string& encoding, const std::string& definition) {
    record('\x03', number(id, 2) + text(name) + text(encoding) + text(definition));
  }
  void channel(std::uint16_t id, std::uint16_t schema, const std::string& topic, const std::string& encoding) {
    record('\x04', number(id, 2) + number(schema, 2) + text(topic) + text(encoding) + number(0, 4));
  }
  /// `time`: ns.
  void message(std::uint16_t channel, std::uint64_t time, const std::string& content) {
    record('\x05', number(channel, 2) + number(0, 4) + number(time, 8) + number(time, 8) + content);
  }
  void chunk(const std::string& compression, std::uint64_t size, const std::string& packed) {
    record('\x06',
           number(0, 16) + number(size, 8) + number(0, 4) + text(compression) + number(packed.size(), 8) + packed);
  }
  std::string whole() const {
    McapBytes ended = *this;
    ended.record('\x0f', number(0, 4));
    ended.record('\x02', number(0, 20));
    return kMagic + ended.records_ + kMagic;
  }

 private:
  static inline const std::string kMagic{"\x89MCAP0\r\n", 8};

  static std::string number(std::uint64_t value, int width) {
    std::string bytes;
    for (int i = 0; i < width; ++i) bytes += static_cast<char>(i < 8 ? value >> (8 * i) & 0xff : 0);
    return bytes;
  }
  static std::string text(const std::string& text) { return number(text.size(), 4) + text; }
  void record(char opcode, const std::string& content) { records_ += opcode + number(content.size(), 8) + content; }

  std::string records_;
};

}  // namespace lacuna
