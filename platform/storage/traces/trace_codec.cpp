#include "storage/traces/trace_codec.h"

#include <lacuna/error.h>

#include "foundation/digest.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <cstring>

namespace lacuna {
namespace {

static_assert(std::endian::native == std::endian::little, "blobs are little-endian");

constexpr std::size_t kUniformTimes = 2;  ///< start and step stand for all times

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

std::string digest_of(const EncodedTrace& trace) {
  const auto part = [](const std::vector<std::byte>& bytes) {
    return sha256({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };
  return sha256(trace.channels + '\n' + std::to_string(trace.sample_count) + '\n' + to_string(trace.precision) + '\n' +
                part(trace.times) + '\n' + part(trace.samples));
}

}  // namespace

std::string to_string(TracePrecision precision) { return precision == TracePrecision::float32 ? "float32" : "float64"; }

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
    throw Error("a stored time series is damaged: its bytes do not match its digest; restore a copy of the database");
  }
  TimeSeries series;
  for (const nlohmann::json& channel : nlohmann::json::parse(trace.channels)) {
    series.channels.push_back({channel.at("name").get<std::string>(), channel.at("unit").get<std::string>()});
  }
  series.times = decode_times(trace.times, trace.sample_count);
  const Eigen::ArrayXd flat = trace.precision == TracePrecision::float32
                                  ? Eigen::ArrayXd(from_bytes<float>(trace.samples).cast<double>())
                                  : from_bytes<double>(trace.samples);
  series.samples = Eigen::Map<const TimeSeries::Samples>(flat.data(), trace.sample_count,
                                                         static_cast<Eigen::Index>(series.channels.size()));
  return series;
}

}  // namespace lacuna
