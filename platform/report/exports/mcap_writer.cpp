#include "report/exports/mcap_writer.h"

#include "report/exports/little_endian.h"

#include <zlib.h>

#include <algorithm>
#include <numeric>

namespace lacuna {
namespace {

constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

/// Records by their opcodes.
enum class Opcode : char {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0b,
  data_end = 0x0f
};

std::uint32_t checksum_of(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void append_text(std::string& bytes, std::string_view text) {
  append_number(bytes, text.size(), 4);
  bytes += text;
}

std::string record(Opcode opcode, std::string_view content) {
  std::string bytes(1, static_cast<char>(opcode));
  append_number(bytes, content.size(), 8);
  bytes += content;
  return bytes;
}

std::uint16_t id_of(std::size_t channel) { return static_cast<std::uint16_t>(channel + 1); }

std::string schema_record(std::size_t index, const McapChannel& channel) {
  std::string content;
  append_number(content, id_of(index), 2);
  append_text(content, channel.schema_name);
  append_text(content, "jsonschema");
  append_text(content, channel.schema);
  return record(Opcode::schema, content);
}

std::string channel_record(std::size_t index, const McapChannel& channel) {
  std::string metadata;
  for (const auto& [key, value] : channel.metadata) {
    append_text(metadata, key);
    append_text(metadata, value);
  }
  std::string content;
  append_number(content, id_of(index), 2);
  append_number(content, id_of(index), 2);  // its schema
  append_text(content, channel.topic);
  append_text(content, "json");
  append_text(content, metadata);
  return record(Opcode::channel, content);
}

std::string records_of(const std::vector<McapChannel>& channels) {
  std::string records;
  for (std::size_t i = 0; i < channels.size(); ++i)
    records += schema_record(i, channels[i]) + channel_record(i, channels[i]);
  return records;
}

}  // namespace

McapWriter::McapWriter(std::ostream& stream, std::vector<McapChannel> channels, std::size_t chunk_size)
    : stream_(stream), channels_(std::move(channels)), chunk_size_(chunk_size), counts_(channels_.size(), 0) {
  std::string content;
  append_text(content, "");  // no profile
  append_text(content, "lacuna");
  write(kMcapMagic);
  write(record(Opcode::header, content));
  chunk_ = records_of(channels_);
}

void McapWriter::write(std::string_view bytes) {
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  place_ += bytes.size();
  checksum_ = checksum_of(bytes, checksum_);
}

void McapWriter::add(std::size_t channel, std::uint64_t time, std::string_view json) {
  if (index_.empty()) first_time_ = time;
  last_time_ = time;
  index_[id_of(channel)].emplace_back(time, chunk_.size());
  std::string content;
  append_number(content, id_of(channel), 2);
  append_number(content, counts_[channel]++, 4);
  append_number(content, time, 8);  // of recording
  append_number(content, time, 8);  // of publishing
  content += json;
  chunk_ += record(Opcode::message, content);
  if (chunk_.size() >= chunk_size_) end_chunk();
}

void McapWriter::end_chunk() {
  std::string content;
  append_number(content, first_time_, 8);
  append_number(content, last_time_, 8);
  append_number(content, chunk_.size(), 8);
  append_number(content, checksum_of(chunk_), 4);
  append_text(content, "");  // not compressed
  append_number(content, chunk_.size(), 8);
  content += chunk_;
  ChunkPlace chunk{first_time_, last_time_, place_, 0, {}, 0, chunk_.size()};
  write(record(Opcode::chunk, content));
  chunk.size = place_ - chunk.start;
  const std::uint64_t indices = place_;
  for (const auto& [channel, messages] : index_) {
    chunk.index_offsets[channel] = place_;
    std::string index;
    append_number(index, channel, 2);
    append_number(index, 16 * messages.size(), 4);
    for (const auto& [time, offset] : messages) {
      append_number(index, time, 8);
      append_number(index, offset, 8);
    }
    write(record(Opcode::message_index, index));
  }
  chunk.index_size = place_ - indices;
  chunks_.push_back(std::move(chunk));
  chunk_.clear();
  index_.clear();
}

std::string McapWriter::statistics() const {
  std::string content;
  append_number(content, std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}), 8);
  append_number(content, channels_.size(), 2);  // schemas
  append_number(content, channels_.size(), 4);
  append_number(content, 0, 4);  // attachments
  append_number(content, 0, 4);  // metadata
  append_number(content, chunks_.size(), 4);
  append_number(content, chunks_.empty() ? 0 : chunks_.front().first_time, 8);
  append_number(content, chunks_.empty() ? 0 : chunks_.back().last_time, 8);
  append_number(content, 10 * counts_.size(), 4);
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    append_number(content, id_of(i), 2);
    append_number(content, counts_[i], 8);
  }
  return record(Opcode::statistics, content);
}

std::string McapWriter::summary() const {
  std::string records = records_of(channels_) + statistics();
  for (const ChunkPlace& chunk : chunks_) {
    std::string content;
    append_number(content, chunk.first_time, 8);
    append_number(content, chunk.last_time, 8);
    append_number(content, chunk.start, 8);
    append_number(content, chunk.size, 8);
    append_number(content, 10 * chunk.index_offsets.size(), 4);
    for (const auto& [channel, offset] : chunk.index_offsets) {
      append_number(content, channel, 2);
      append_number(content, offset, 8);
    }
    append_number(content, chunk.index_size, 8);
    append_text(content, "");  // not compressed
    append_number(content, chunk.content_size, 8);
    append_number(content, chunk.content_size, 8);
    records += record(Opcode::chunk_index, content);
  }
  return records;
}

void McapWriter::finish() {
  if (!chunk_.empty()) end_chunk();
  std::string data_checksum;
  append_number(data_checksum, checksum_, 4);
  write(record(Opcode::data_end, data_checksum));
  constexpr std::uint64_t kFooter = 20;  ///< bytes of its content
  std::string end = summary();
  const std::uint64_t summary_start = place_;
  end += static_cast<char>(Opcode::footer);
  append_number(end, kFooter, 8);
  append_number(end, summary_start, 8);
  append_number(end, 0, 8);  // no offsets of groups
  append_number(end, checksum_of(end), 4);
  write(end);
  write(kMcapMagic);
}

}  // namespace lacuna
