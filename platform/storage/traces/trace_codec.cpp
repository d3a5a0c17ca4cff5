#include "storage/traces/trace_codec.h"

#include <lacuna/error.h>

#include "foundation/digest.h"
#include "foundation/text/json_depth.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstring>

namespace lacuna {
namespace {

static_assert(std::endian::native == std::endian::little, "blobs are little-endian");

constexpr std::size_t kUniformTimes = 2;                  ///< start and step stand for all times
constexpr std::size_t kMostWithoutChannels = 10'000'000;  ///< times, of which no sample says that there are so many

template <class Number>
std::vector<std::byte> to_bytes(const Eigen::Array<Number, Eigen::Dynamic, 1>& numbers) {
  std::vector<std::byte> bytes(static_cast<std::size_t>(numbers.size()) * sizeof(Number));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

template <class Number>
Eigen::Array<Number, Eigen::Dynamic, 1> from_bytes(const std::vector<std::byte>& bytes) {
  Eigen::Array<Number, Eigen::Dynamic, 1> numbers(static_cast<Eigen::Index>(bytes.size() / sizeof(Number)));
  if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

double time_at(double start, double step, Eigen::Index index) { return start + step * static_cast<double>(index); }

std::vector<std::byte> encode_times(const Eigen::VectorXd& times) {
  if (times.size() > static_cast<Eigen::Index>(kUniformTimes)) {
    // The mean interval is nearer to the clock's own than the first difference, which is rounded.
    const double step = (times[times.size() - 1] - times[0]) / static_cast<double>(times.size() - 1);
    bool uniform = true;
    for (Eigen::Index i = 0; i < times.size() && uniform; ++i) uniform = times[i] == time_at(times[0], step, i);
    if (uniform) return to_bytes<double>(Eigen::Array2d(times[0], step));
  }
  return to_bytes<double>(times.array());
}

Eigen::VectorXd decode_times(const std::vector<std::byte>& bytes, Eigen::Index count) {
  const Eigen::ArrayXd numbers = from_bytes<double>(bytes);
  if (numbers.size() == count) return numbers.matrix();
  Eigen::VectorXd times(count);
  for (Eigen::Index i = 0; i < count; ++i) times[i] = time_at(numbers[0], numbers[1], i);
  return times;
}

[[noreturn]] void throw_inconsistent() {
  throw Error("a stored time series is inconsistent: its parts have different sizes; restore a backup of the database");
}

[[noreturn]] void throw_unreadable_channels() {
  throw Error("a stored time series is damaged: its channels cannot be read; restore a backup of the database");
}

std::vector<Channel> decode_channels(const std::string& text) try {
  std::vector<Channel> channels;
  if (nests_too_deep(text)) throw_unreadable_channels();
  for (const nlohmann::json& channel : nlohmann::json::parse(text))
    channels.push_back({channel.at("name").get<std::string>(), channel.at("unit").get<std::string>()});
  return channels;
} catch (const nlohmann::json::exception&) {
  throw_unreadable_channels();
}

/// A digest says that the bytes are those that were written, not who wrote them.
void check_sizes(const EncodedTrace& trace, std::size_t channels) {
  const std::size_t width = trace.precision == TracePrecision::float32 ? sizeof(float) : sizeof(double);
  const std::size_t numbers = trace.samples.size() / width;
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(trace.sample_count, 0));
  const bool has_samples = channels == 0 ? numbers == 0 && count <= kMostWithoutChannels
                                         : numbers % channels == 0 && numbers / channels == count;
  const bool has_times = trace.times.size() == count * sizeof(double) ||
                         (count > kUniformTimes && trace.times.size() == kUniformTimes * sizeof(double));
  if (trace.sample_count < 0 || trace.samples.size() % width != 0 || !has_samples || !has_times) throw_inconsistent();
}

}  // namespace

std::string to_string(TracePrecision precision) { return precision == TracePrecision::float32 ? "float32" : "float64"; }

std::string digest_of(const EncodedTrace& trace) {
  const auto part = [](const std::vector<std::byte>& bytes) {
    return sha256({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };
  return sha256(trace.channels + '\n' + std::to_string(trace.sample_count) + '\n' + to_string(trace.precision) + '\n' +
                part(trace.times) + '\n' + part(trace.samples));
}

EncodedTrace encode_trace(const TimeSeries& series, TracePrecision precision) {
  EncodedTrace trace;
  nlohmann::json channels = nlohmann::json::array();
  for (const Channel& channel : series.channels) channels.push_back({{"name", channel.name}, {"unit", channel.unit}});
  trace.channels = channels.dump();
  trace.sample_count = series.samples.rows();
  trace.precision = precision;
  trace.times = encode_times(series.times);
  const Eigen::ArrayXd flat = Eigen::Map<const Eigen::ArrayXd>(series.samples.data(), series.samples.size());
  trace.samples = precision == TracePrecision::float32 ? to_bytes<float>(flat.cast<float>()) : to_bytes<double>(flat);
  trace.digest = digest_of(trace);
  return trace;
}

TimeSeries decode_trace(const EncodedTrace& trace) {
  if (digest_of(trace) != trace.digest) {
    throw Error("a stored time series is damaged: its bytes do not match its digest; restore a backup of the database");
  }
  TimeSeries series;
  series.channels = decode_channels(trace.channels);
  check_sizes(trace, series.channels.size());
  series.times = decode_times(trace.times, trace.sample_count);
  const Eigen::ArrayXd flat = trace.precision == TracePrecision::float32
                                  ? Eigen::ArrayXd(from_bytes<float>(trace.samples).cast<double>())
                                  : from_bytes<double>(trace.samples);
  series.samples = Eigen::Map<const TimeSeries::Samples>(flat.data(), trace.sample_count,
                                                         static_cast<Eigen::Index>(series.channels.size()));
  return series;
}

}  // namespace lacuna
