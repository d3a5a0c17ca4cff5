#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace lacuna {

/// Writes a ZIP archive of stored members (APPNOTE.TXT 6.3.10) to a stream, from its beginning to its end. Members have
/// no date, so that the same members are the same bytes. Sizes that need more than 32 bits are written as ZIP64.
class ZipWriter {
 public:
  static constexpr std::uint64_t kMostIn32 = 0xfffffffe;

  /// Takes the content of a member piece by piece.
  using Sink = std::function<void(std::string_view)>;
  using Content = std::function<void(const Sink&)>;

  /// `most_in_32`: the largest number that is not written as ZIP64.
  explicit ZipWriter(std::ostream& stream, std::uint64_t most_in_32 = kMostIn32);

  /// Asks for the content twice: for its checksum, and to write it.
  void add(const std::string& name, const Content& content);
  /// The directory. Nothing may follow.
  void finish();

 private:
  void write(std::string_view bytes);

  std::ostream& stream_;
  std::uint64_t most_in_32_;
  std::uint64_t place_ = 0;  ///< bytes written
  std::uint64_t members_ = 0;
  std::string directory_;
};

}  // namespace lacuna
