#include "storage/files/log_content.h"

#include <algorithm>
#include <cstring>
#include <fstream>

namespace lacuna {
namespace {

constexpr std::size_t kMarkSize = 32;
constexpr std::size_t kLogHeader = 32, kFrameHeader = 24;
constexpr std::uint32_t kLogMagic = 0x377f0682;  // the last bit says how checksums are computed
constexpr std::string_view kJournalMagic = "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";
constexpr std::size_t kJournalHeader = 28;

std::uint32_t big_endian(const char* bytes) {
  std::uint32_t number = 0;
  for (int i = 0; i < 4; ++i) number = number << 8U | static_cast<unsigned char>(bytes[i]);
  return number;
}

bool is_page_size(std::uint32_t size) { return size >= 512 && size <= 65536 && (size & (size - 1)) == 0; }

bool fill(std::istream& stream, std::string& bytes) {
  return static_cast<bool>(stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())));
}

bool is_mark(std::string_view text) { return text.find_first_not_of("0123456789abcdef") == std::string_view::npos; }

}  // namespace

std::vector<LogMark> marks_in(std::string_view bytes) {
  constexpr std::size_t kWhole = kMarkWord.size() + 2 * kMarkSize + 1;
  std::vector<LogMark> marks;
  for (std::size_t at = bytes.find(kMarkWord); at != std::string_view::npos && at + kWhole <= bytes.size();
       at = bytes.find(kMarkWord, at + 1)) {
    const std::string_view before = bytes.substr(at + kMarkWord.size(), kMarkSize);
    const std::string_view now = bytes.substr(at + kMarkWord.size() + kMarkSize + 1, kMarkSize);
    if (is_mark(before) && is_mark(now)) marks.push_back({std::string(before), std::string(now)});
  }
  return marks;
}

FileHeader::FileHeader(std::string_view bytes) {
  std::copy_n(bytes.begin(), std::min(bytes.size(), kSize), bytes_.begin());
}

std::uint32_t FileHeader::number(std::size_t at) const { return big_endian(bytes_.data() + at); }

bool FileHeader::is_database() const {
  static constexpr char kMagic[] = "SQLite format 3";  // with the zero byte at its end
  return std::memcmp(bytes_.data(), kMagic, sizeof kMagic) == 0 && is_page_size(page_size());
}

std::uint32_t FileHeader::page_size() const {
  const std::uint32_t size = number(14) & 0xffffU;
  return size == 1 ? 65536 : size;
}

std::optional<std::uint32_t> FileHeader::pages() const {
  constexpr std::size_t kValidFor = 92;
  return number(28) > 0 && number(kValidFor) == change_counter() ? std::optional(number(28)) : std::nullopt;
}

bool FileHeader::is_blank() const {
  constexpr std::size_t kKind = 100, kCells = 103;
  constexpr char kLeaf = 0x0d;
  return bytes_[kKind] == kLeaf && bytes_[kCells] == 0 && bytes_[kCells + 1] == 0;
}

std::uint32_t WriteAheadLog::for_each_frame(const std::function<bool(const LogFrame&)>& look) const {
  std::ifstream stream(file_, std::ios::binary);
  std::string header(kLogHeader, '\0');
  if (!fill(stream, header) || (big_endian(header.data()) & ~1U) != kLogMagic) return 0;
  const std::uint32_t page_size = big_endian(header.data() + 8);
  if (!is_page_size(page_size)) return 0;
  const std::string salts = header.substr(16, 8);
  std::string frame(kFrameHeader + page_size, '\0');
  while (fill(stream, frame) && frame.compare(8, 8, salts) == 0) {
    const LogFrame next{.page = big_endian(frame.data()),
                        .pages_at_commit = big_endian(frame.data() + 4),
                        .content = std::string_view(frame).substr(kFrameHeader)};
    if (!look(next)) break;
  }
  return page_size;
}

RollbackJournal read_journal(const std::filesystem::path& file) {
  constexpr std::uint32_t kToTheEnd = 0xffffffffU;
  RollbackJournal journal;
  std::ifstream stream(file, std::ios::binary);
  std::string header(kJournalHeader, '\0');
  // Segments, each with a header at the beginning of a sector.
  while (!journal.first_page && fill(stream, header) && header.starts_with(kJournalMagic)) {
    const std::uint32_t records = big_endian(header.data() + 8);
    const std::uint32_t sector = big_endian(header.data() + 20);
    if (!journal.hot) {
      journal.pages = big_endian(header.data() + 16);
      journal.page_size = big_endian(header.data() + 24);
    }
    journal.hot = is_page_size(journal.page_size) && sector >= kJournalHeader && sector <= 65536;
    if (!journal.hot) break;
    stream.seekg(static_cast<std::streamoff>(stream.tellg()) - static_cast<std::streamoff>(kJournalHeader) + sector);
    std::string record(4 + journal.page_size + 4, '\0');
    for (std::uint32_t i = 0; (records == kToTheEnd || i < records) && !journal.first_page && fill(stream, record); ++i)
      if (big_endian(record.data()) == 1) journal.first_page.emplace(std::string_view(record).substr(4));
    const std::streamoff end = stream.tellg();
    if (end < 0) break;
    stream.seekg((end + sector - 1) / sector * sector);
  }
  return journal;
}

}  // namespace lacuna
