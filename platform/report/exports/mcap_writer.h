#pragma once

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lacuna {

/// Messages in JSON on one topic.
struct McapChannel {
  std::string topic;
  std::string schema_name;
  std::string schema;                           ///< JSON Schema of its messages
  std::map<std::string, std::string> metadata;  ///< what else is to be known of it
};

/// Writes an MCAP file (specification of version 0) to a stream, from its beginning to its end: chunks without
/// compression, their indices, and a summary. The same messages are the same bytes. `stream` outlives the object.
class McapWriter {
 public:
  static constexpr std::size_t kChunkSize = std::size_t{1} << 20;  ///< bytes, about

  McapWriter(std::ostream& stream, std::vector<McapChannel> channels, std::size_t chunk_size = kChunkSize);

  /// `channel`: index; `time`: ns. Messages come in the order of their times.
  void add(std::size_t channel, std::uint64_t time, std::string_view json);
  /// The summary. Nothing may follow.
  void finish();

 private:
  struct ChunkPlace {
    std::uint64_t first_time = 0, last_time = 0;           ///< ns
    std::uint64_t start = 0, size = 0;                     ///< of its record in the file
    std::map<std::uint16_t, std::uint64_t> index_offsets;  ///< of the channels' message indices, by id
    std::uint64_t index_size = 0, content_size = 0;
  };
  using ChunkIndex = std::vector<std::pair<std::uint64_t, std::uint64_t>>;  ///< time and place of each message

  void write(std::string_view bytes);
  void end_chunk();
  std::string summary() const;
  std::string statistics() const;

  std::ostream& stream_;
  std::vector<McapChannel> channels_;
  std::size_t chunk_size_;
  std::uint64_t place_ = 0;                       ///< bytes written
  std::uint32_t checksum_ = 0;                    ///< of them
  std::string chunk_;                             ///< records that wait
  std::uint64_t first_time_ = 0, last_time_ = 0;  ///< of the messages that wait, ns
  std::map<std::uint16_t, ChunkIndex> index_;     ///< of the messages that wait, by channel
  std::vector<std::uint64_t> counts_;             ///< messages, one a channel
  std::vector<ChunkPlace> chunks_;
};

}  // namespace lacuna
