#include "zip_archive.h"

#include <algorithm>
#include <array>
#include <span>

namespace lacuna::numpy {
namespace {

constexpr std::size_t kEndSize = 22, kEntrySize = 46, kLocalSize = 30, kLocatorSize = 20, kEnd64Size = 56;
constexpr std::uint32_t kEndSign = 0x06054b50, kEntrySign = 0x02014b50, kLocalSign = 0x04034b50;
constexpr std::uint32_t kLocatorSign = 0x07064b50, kEnd64Sign = 0x06064b50;
constexpr std::size_t kLongestComment = 65535;
constexpr std::uint64_t kLargestDirectory = std::uint64_t{64} << 20;
constexpr std::uint32_t kIn64 = 0xffffffff;  ///< the number is in a ZIP64 record
constexpr std::uint16_t kEncrypted = 1;

using Bytes = std::span<const unsigned char>;

std::uint64_t number(Bytes bytes, std::size_t place, std::size_t width) {
  std::uint64_t value = 0;
  for (std::size_t i = width; i-- > 0;) value = value << 8 | bytes[place + i];
  return value;
}

[[noreturn]] void throw_damaged(const char* what) {
  throw BadFile(std::string("is not a complete .npz file: ") + what + "; copy the file again or write it anew");
}

std::vector<unsigned char> bytes_at(RandomFile& file, std::uint64_t place, std::size_t count, const char* what) {
  std::vector<unsigned char> bytes(count);
  if (place > file.size() || count > file.size() - place || file.read_at(place, bytes.data(), count) < count)
    throw_damaged(what);
  return bytes;
}

struct Directory {
  std::uint64_t place = 0, size = 0;
};

/// The stated place of the ZIP64 record, if there is one.
void take_zip64(RandomFile& file, std::uint64_t end_place, Directory& directory) {
  if (end_place < kLocatorSize) return;
  const auto locator = bytes_at(file, end_place - kLocatorSize, kLocatorSize, "its end is incomplete");
  if (number(locator, 0, 4) != kLocatorSign) return;
  const auto record = bytes_at(file, number(locator, 8, 8), kEnd64Size, "its ZIP64 record lies outside the file");
  if (number(record, 0, 4) != kEnd64Sign) throw_damaged("its ZIP64 record is invalid");
  directory = {number(record, 48, 8), number(record, 40, 8)};
}

Directory find_directory(RandomFile& file) {
  const auto tail_size = static_cast<std::size_t>(std::min<std::uint64_t>(file.size(), kEndSize + kLongestComment));
  if (tail_size < kEndSize) throw_damaged("it is too short");
  const std::uint64_t start = file.size() - tail_size;
  const auto tail = bytes_at(file, start, tail_size, "it cannot be read completely");
  for (std::size_t i = tail_size - kEndSize + 1; i-- > 0;) {
    if (number(tail, i, 4) != kEndSign) continue;
    Directory directory{number(tail, i + 16, 4), number(tail, i + 12, 4)};
    take_zip64(file, start + i, directory);
    return directory;
  }
  throw_damaged("it has no directory at its end");
}

/// Sizes and place that do not fit into 32 bits are in the extra field 1, in that order.
void take_extra(Bytes extra, std::array<std::uint64_t*, 3> numbers) {
  while (extra.size() >= 4) {
    const std::size_t id = number(extra, 0, 2), size = number(extra, 2, 2);
    if (size > extra.size() - 4) throw_damaged("an entry of its directory is incomplete");
    Bytes field = extra.subspan(4, size);
    for (std::uint64_t* one : numbers) {
      if (id != 1 || *one != kIn64) continue;
      if (field.size() < 8) throw_damaged("an entry of its directory is incomplete");
      *one = number(field, 0, 8);
      field = field.subspan(8);
    }
    extra = extra.subspan(4 + size);
  }
}

/// The place of a member's data, after its local header.
std::uint64_t data_place(RandomFile& file, std::uint64_t local) {
  const auto header = bytes_at(file, local, kLocalSize, "a member lies outside the file");
  if (number(header, 0, 4) != kLocalSign) throw_damaged("a member has no header");
  return local + kLocalSize + number(header, 26, 2) + number(header, 28, 2);
}

/// Removes the first entry from `rest`.
ZipMember take_entry(RandomFile& file, Bytes& rest) {
  if (rest.size() < kEntrySize || number(rest, 0, 4) != kEntrySign) throw_damaged("its directory is damaged");
  const std::size_t name = number(rest, 28, 2), extra = number(rest, 30, 2), comment = number(rest, 32, 2);
  if (rest.size() - kEntrySize < name + extra + comment) throw_damaged("its directory is incomplete");
  ZipMember member;
  member.name.assign(reinterpret_cast<const char*>(rest.data()) + kEntrySize, name);
  member.checksum = static_cast<std::uint32_t>(number(rest, 16, 4));
  member.packed_size = number(rest, 20, 4);
  member.size = number(rest, 24, 4);
  std::uint64_t local = number(rest, 42, 4);
  take_extra(rest.subspan(kEntrySize + name, extra), {&member.size, &member.packed_size, &local});
  const auto method = number(rest, 10, 2);
  if ((number(rest, 8, 2) & kEncrypted) != 0) throw BadFile("is encrypted; write it without a password");
  if (method != 0 && method != 8)
    throw BadFile("is compressed with a method that numpy does not use (method " + std::to_string(method) +
                  "); write it with numpy.savez or numpy.savez_compressed");
  member.is_deflated = method == 8;
  member.place = data_place(file, local);
  if (member.place > file.size() || member.packed_size > file.size() - member.place)
    throw_damaged("a member continues beyond its end");
  if (!member.is_deflated && member.size != member.packed_size) throw_damaged("a stored member has two sizes");
  rest = rest.subspan(kEntrySize + name + extra + comment);
  return member;
}

}  // namespace

std::vector<ZipMember> members_of(RandomFile& file) {
  const Directory directory = find_directory(file);
  if (directory.size > kLargestDirectory) throw_damaged("its directory has more than 64 MiB");
  const auto bytes =
      bytes_at(file, directory.place, static_cast<std::size_t>(directory.size), "its directory lies outside the file");
  Bytes rest = bytes;
  std::vector<ZipMember> members;
  while (!rest.empty()) members.push_back(take_entry(file, rest));
  return members;
}

}  // namespace lacuna::numpy
