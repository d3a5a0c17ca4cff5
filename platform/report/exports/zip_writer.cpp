#include "report/exports/zip_writer.h"

#include "report/exports/little_endian.h"

#include <zlib.h>

namespace lacuna {
namespace {

constexpr std::uint32_t kLocalSign = 0x04034b50, kEntrySign = 0x02014b50, kEndSign = 0x06054b50;
constexpr std::uint32_t kEnd64Sign = 0x06064b50, kLocator64Sign = 0x07064b50;
constexpr std::uint64_t kIn64 = 0xffffffff;    ///< the number stands in a ZIP64 field
constexpr int kVersion = 20, kVersion64 = 45;  ///< of the format, ten times
constexpr int kUtf8Name = 0x0800;
constexpr int kNoDate = 0x0021;  ///< 1980-01-01, the first day that there is
constexpr int kField64 = 1;
constexpr std::uint64_t kRestOfEnd64 = 44;  ///< bytes behind its length

/// What is known of a member's content.
struct Checked {
  std::uint64_t size = 0;
  std::uint32_t checksum = 0;
};

Checked checked(const ZipWriter::Content& content) {
  Checked found;
  uLong sum = crc32_z(0, nullptr, 0);
  content([&](std::string_view piece) {
    sum = crc32_z(sum, reinterpret_cast<const Bytef*>(piece.data()), piece.size());
    found.size += piece.size();
  });
  found.checksum = static_cast<std::uint32_t>(sum);
  return found;
}

/// What the local header and the directory say alike, from the version that is needed on.
std::string shared_part(const std::string& name, const Checked& content, bool is_long, std::size_t extra) {
  std::string bytes;
  append_number(bytes, is_long ? kVersion64 : kVersion, 2);
  append_number(bytes, kUtf8Name, 2);
  append_number(bytes, 0, 2);  // stored
  append_number(bytes, 0, 2);  // midnight
  append_number(bytes, kNoDate, 2);
  append_number(bytes, content.checksum, 4);
  append_number(bytes, is_long ? kIn64 : content.size, 4);  // packed
  append_number(bytes, is_long ? kIn64 : content.size, 4);
  append_number(bytes, name.size(), 2);
  append_number(bytes, extra, 2);
  return bytes;
}

/// The field of a header with numbers that have 64 bits.
std::string field_64(std::initializer_list<std::uint64_t> numbers) {
  std::string bytes;
  append_number(bytes, kField64, 2);
  append_number(bytes, 8 * numbers.size(), 2);
  for (const std::uint64_t number : numbers) append_number(bytes, number, 8);
  return bytes;
}

std::string local_header(const std::string& name, const Checked& content, bool is_long) {
  const std::string extra = is_long ? field_64({content.size, content.size}) : "";
  std::string bytes;
  append_number(bytes, kLocalSign, 4);
  return bytes + shared_part(name, content, is_long, extra.size()) + name + extra;
}

std::string directory_entry(const std::string& name, const Checked& content, std::uint64_t place, bool is_long) {
  const std::string extra = is_long ? field_64({content.size, content.size, place}) : "";
  std::string bytes;
  append_number(bytes, kEntrySign, 4);
  append_number(bytes, is_long ? kVersion64 : kVersion, 2);  // made by
  bytes += shared_part(name, content, is_long, extra.size());
  append_number(bytes, 0, 2);  // no comment
  append_number(bytes, 0, 2);  // the first disk
  append_number(bytes, 0, 2);  // bytes, not text
  append_number(bytes, 0, 4);
  append_number(bytes, is_long ? kIn64 : place, 4);
  return bytes + name + extra;
}

struct Directory {
  std::uint64_t place = 0, size = 0, entries = 0;
};

std::string end_64(const Directory& directory) {
  std::string bytes;
  append_number(bytes, kEnd64Sign, 4);
  append_number(bytes, kRestOfEnd64, 8);
  append_number(bytes, kVersion64, 2);
  append_number(bytes, kVersion64, 2);
  append_number(bytes, 0, 8);  // this disk, and the directory's
  append_number(bytes, directory.entries, 8);
  append_number(bytes, directory.entries, 8);
  append_number(bytes, directory.size, 8);
  append_number(bytes, directory.place, 8);
  append_number(bytes, kLocator64Sign, 4);
  append_number(bytes, 0, 4);
  append_number(bytes, directory.place + directory.size, 8);
  append_number(bytes, 1, 4);  // of one disk
  return bytes;
}

std::string end_of(const Directory& directory, bool is_long) {
  constexpr std::uint64_t kEntriesIn64 = 0xffff;
  std::string bytes;
  append_number(bytes, kEndSign, 4);
  append_number(bytes, 0, 4);
  append_number(bytes, is_long ? kEntriesIn64 : directory.entries, 2);
  append_number(bytes, is_long ? kEntriesIn64 : directory.entries, 2);
  append_number(bytes, is_long ? kIn64 : directory.size, 4);
  append_number(bytes, is_long ? kIn64 : directory.place, 4);
  append_number(bytes, 0, 2);
  return bytes;
}

}  // namespace

ZipWriter::ZipWriter(std::ostream& stream, std::uint64_t most_in_32) : stream_(stream), most_in_32_(most_in_32) {}

void ZipWriter::write(std::string_view bytes) {
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  place_ += bytes.size();
}

void ZipWriter::add(const std::string& name, const Content& content) {
  const auto found = checked(content);
  const std::uint64_t start = place_;
  const bool is_long = found.size > most_in_32_ || start > most_in_32_;
  write(local_header(name, found, is_long));
  content([&](std::string_view piece) { write(piece); });
  directory_ += directory_entry(name, found, start, is_long);
  ++members_;
}

void ZipWriter::finish() {
  constexpr std::uint64_t kMostEntries = 0xfffe;
  const Directory directory{place_, directory_.size(), members_};
  const bool is_long = place_ > most_in_32_ || directory.size > most_in_32_ || members_ > kMostEntries;
  write(directory_);
  if (is_long) write(end_64(directory));
  write(end_of(directory, is_long));
}

}  // namespace lacuna
