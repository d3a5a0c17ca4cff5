#include "mcap_records.h"
#include "message_pack.h"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace lacuna::rosbag2 {
namespace {

constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};
constexpr std::uint64_t kRecordHead = 9;                            ///< bytes: opcode and length
constexpr std::uint64_t kFooter = kRecordHead + 20;                 ///< bytes of the footer's record
constexpr std::uint64_t kLargestRecord = std::uint64_t{256} << 20;  ///< bytes
constexpr std::uint64_t kPiece = std::uint64_t{1} << 18;            ///< bytes read at once

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// The place of a record, and the length of its content.
struct RecordPlace {
  McapOpcode opcode{};
  std::uint64_t start = 0, size = 0;
};

/// A file of records.
class RecordFile {
 public:
  explicit RecordFile(const std::string& path) : file_(std::fopen(path.c_str(), "rb")) {
    if (!file_) throw BadBag(std::string("cannot be opened: ") + std::strerror(errno));
    if (::fseeko(file_.get(), 0, SEEK_END) != 0)
      throw BadBag("is not a file that can be read from any position; name a file");
    size_ = static_cast<std::uint64_t>(::ftello(file_.get()));
    const Bytes magic = read(0, kMcapMagic.size());
    if (magic.size() < kMcapMagic.size() || std::memcmp(magic.data(), kMcapMagic.data(), kMcapMagic.size()) != 0)
      throw BadBag("is not an MCAP file: it does not begin with \\x89MCAP0");
  }

  std::uint64_t size() const { return size_; }

  /// The record at that place; false where there is no complete one.
  bool record_at(std::uint64_t place, RecordPlace& record) {
    const Bytes head = read(place, kRecordHead);
    if (head.size() < kRecordHead) return false;
    ByteReader reader(head, "");
    record.opcode = static_cast<McapOpcode>(reader.number(1));
    record.start = place + kRecordHead;
    record.size = reader.number(8);
    return record.size <= size_ - record.start;
  }

  /// Valid until the next read.
  Bytes content(const RecordPlace& record) {
    if (record.size > kLargestRecord)
      throw BadBag("has a record of more than 256 MiB at byte " + std::to_string(record.start));
    const Bytes content = read(record.start, record.size);
    if (content.size() < record.size) throw BadBag(std::string("cannot be read completely: ") + std::strerror(errno));
    return content;
  }

 private:
  /// The available bytes, at most `count`. Consecutive small pieces are read together.
  Bytes read(std::uint64_t place, std::uint64_t count) {
    if (place >= size_) return {};
    count = std::min(count, size_ - place);
    if (place < held_from_ || place + count > held_from_ + held_) fill(place, std::max(count, kPiece));
    const std::uint64_t from = place - held_from_;
    return Bytes(buffer_).subspan(static_cast<std::size_t>(from),
                                  static_cast<std::size_t>(std::min(count, held_ - std::min(held_, from))));
  }

  void fill(std::uint64_t place, std::uint64_t count) {
    count = std::min(count, size_ - place);
    if (buffer_.size() < count) buffer_.resize(static_cast<std::size_t>(count));
    held_from_ = place;
    held_ = 0;
    if (::fseeko(file_.get(), static_cast<off_t>(place), SEEK_SET) == 0)
      held_ = std::fread(buffer_.data(), 1, static_cast<std::size_t>(count), file_.get());
  }

  std::unique_ptr<std::FILE, FileCloser> file_;
  std::uint64_t size_ = 0;
  std::vector<unsigned char> buffer_;
  std::uint64_t held_from_ = 0, held_ = 0;  ///< part of the file in the buffer
};

/// A bag in an MCAP file. Its records are read one after another; the summary at its end only gives the number of
/// messages per topic, and may be missing.
class McapBag : public Bag {
 public:
  explicit McapBag(const std::string& path) : file_(path) { take_summary(); }

  const std::vector<BagTopic>& topics() const override { return topics_.topics(); }
  bool knows_topics() const override { return topics_.has_counts(); }
  std::vector<RecordingSentence> doubts() const override { return doubts_; }

  void visit(const std::function<bool(std::size_t)>& wants,
             const std::function<bool(const BagMessage&)>& visit) override {
    RecordPlace record;
    std::uint64_t place = kMcapMagic.size();
    bool goes_on = true;
    while (goes_on && place < file_.size()) {
      if (!file_.record_at(place, record)) return note_cut(place);
      if (record.opcode == McapOpcode::footer || record.opcode == McapOpcode::data_end) return;
      goes_on = take_record(record, wants, visit);
      place = record.start + record.size;
    }
    if (goes_on) note_cut(place);
  }

 private:
  using Wants = std::function<bool(std::size_t)>;
  using Visit = std::function<bool(const BagMessage&)>;

  bool take_record(const RecordPlace& record, const Wants& wants, const Visit& visit) {
    try {
      if (record.opcode == McapOpcode::chunk) return take_chunk(file_.content(record), wants, visit);
      return take(record.opcode, record, wants, visit);
    } catch (const BadBag& bad) {
      throw BadBag("the record at byte " + std::to_string(record.start - kRecordHead) + " of the file " + bad.what());
    }
  }

  bool take(McapOpcode opcode, const RecordPlace& record, const Wants& wants, const Visit& visit) {
    switch (opcode) {
      case McapOpcode::schema:
      case McapOpcode::channel:
      case McapOpcode::message: return take(opcode, file_.content(record), wants, visit);
      default: return true;
    }
  }

  bool take(McapOpcode opcode, Bytes content, const Wants& wants, const Visit& visit) {
    if (opcode == McapOpcode::schema) topics_.take_schema(content);
    if (opcode == McapOpcode::channel) topics_.take_channel(content);
    if (opcode != McapOpcode::message) return true;
    ByteReader reader(content, "message");
    const std::size_t topic = topics_.topic_of(reader.number(2));
    if (!wants(topic)) return true;
    reader.take(4);  // a number in sequence
    const auto received = static_cast<std::int64_t>(reader.number(8));
    reader.take(8);  // the time of publishing
    return visit({topic, received, reader.rest()});
  }

  bool take_chunk(Bytes content, const Wants& wants, const Visit& visit) {
    ByteReader reader(content, "chunk");
    reader.take(16);  // times of its first and its last message
    const std::uint64_t size = reader.number(8);
    const auto checksum = static_cast<std::uint32_t>(reader.number(4));
    const std::string compression = reader.text();
    const Bytes records = pack_.unpack(reader.take(reader.number(8)), compression);
    if (records.size() != size)
      throw BadBag("unpacks to " + std::to_string(records.size()) + " bytes but states " + std::to_string(size));
    if (checksum != 0 && crc32_z(0, records.data(), records.size()) != checksum)
      throw BadBag("is damaged: its checksum is wrong; copy the file again");
    ByteReader rest(records, "chunk");
    while (!rest.rest().empty()) {
      const auto opcode = static_cast<McapOpcode>(rest.number(1));
      if (!take(opcode, rest.take(rest.number(8)), wants, visit)) return false;
    }
    return true;
  }

  /// Schemas, channels and statistics after the data. Damage there does not matter.
  void take_summary() {
    McapTopics found;
    RecordPlace record;
    if (file_.size() < kFooter + 2 * kMcapMagic.size()) return;
    const std::uint64_t footer = file_.size() - kMcapMagic.size() - kFooter;
    try {
      if (!file_.record_at(footer, record) || record.opcode != McapOpcode::footer) return;
      std::uint64_t place = ByteReader(file_.content(record), "footer").number(8);
      while (place > 0 && place < footer && file_.record_at(place, record)) {
        if (record.opcode == McapOpcode::schema) found.take_schema(file_.content(record));
        if (record.opcode == McapOpcode::channel) found.take_channel(file_.content(record));
        if (record.opcode == McapOpcode::statistics) found.take_statistics(file_.content(record));
        place = record.start + record.size;
      }
    } catch (const BadBag&) {
      return;
    }
    if (found.has_counts()) topics_ = std::move(found);
  }

  void note_cut(std::uint64_t place) {
    doubts_.push_back({0, "the file ends at byte " + std::to_string(place) +
                              ", as after an interrupted recording; the part before it is read"});
  }

  RecordFile file_;
  McapTopics topics_;
  MessagePack pack_;
  std::vector<RecordingSentence> doubts_;
};

}  // namespace

std::unique_ptr<Bag> open_mcap(const std::string& path) { return std::make_unique<McapBag>(path); }

}  // namespace lacuna::rosbag2
