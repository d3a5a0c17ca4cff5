// A stored time series is decoded or refused, whoever made its bytes: its digest may be right. The input: how many
// bytes are times and how many channels, how many samples are claimed, the precision; then the bytes.

#include "fuzzing.h"
#include "storage/traces/trace_codec.h"

#include <cstring>
#include <span>

namespace {

using lacuna::fuzz::require;

struct Head {
  std::uint16_t bytes_of_times, bytes_of_channels;
  std::int64_t sample_count;
  std::uint8_t is_double;
};

std::vector<std::byte> bytes_of(std::string_view part) {
  const auto bytes = std::as_bytes(std::span(part));
  return {bytes.begin(), bytes.end()};
}

std::string cut(std::string_view& rest, std::size_t size) {
  const std::string part(rest.substr(0, size));
  rest.remove_prefix(part.size());
  return part;
}

lacuna::EncodedTrace trace_of(const Head& head, std::string_view rest) {
  lacuna::EncodedTrace trace;
  trace.channels = cut(rest, head.bytes_of_channels);
  trace.times = bytes_of(cut(rest, head.bytes_of_times));
  trace.sample_count = head.sample_count;
  trace.precision = (head.is_double & 1U) != 0 ? lacuna::TracePrecision::float64 : lacuna::TracePrecision::float32;
  trace.samples = bytes_of(rest);
  trace.digest = lacuna::digest_of(trace);
  return trace;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHead = 13;
  if (size < kHead) return 0;
  Head head{};
  std::memcpy(&head.bytes_of_times, data, 2);
  std::memcpy(&head.bytes_of_channels, data + 2, 2);
  std::memcpy(&head.sample_count, data + 4, 8);
  head.is_double = data[12];
  const std::string rest = lacuna::fuzz::text_of(data + kHead, size - kHead);
  lacuna::fuzz::is_done([&] {
    const lacuna::TimeSeries series = lacuna::decode_trace(trace_of(head, rest));
    require(series.times.size() == series.samples.rows(), "there is a row a time");
    require(static_cast<std::size_t>(series.samples.cols()) == series.channels.size(), "there is a column a channel");
    lacuna::encode_trace(series, lacuna::TracePrecision::float64);
  });
  return 0;
}
