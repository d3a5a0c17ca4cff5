#include "storage/asked.h"
#include "storage/small_database.h"
#include "storage/traces/trace_codec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace lacuna {
namespace {

using testing::HasSubstr;

TEST(TraceCodec, Float64GivesBackTheSameBits) {
  TimeSeries series = test::sine(257);
  series.samples(3, 0) = kNotKnown;
  const TimeSeries back = decode_trace(encode_trace(series, TracePrecision::float64));
  EXPECT_EQ(back.channels, series.channels);
  EXPECT_TRUE(back.times == series.times);
  EXPECT_TRUE(std::isnan(back.samples(3, 0)));
  series.samples(3, 0) = 0.0;
  TimeSeries filled = back;
  filled.samples(3, 0) = 0.0;
  EXPECT_TRUE(filled.samples == series.samples);
}

TEST(TraceCodec, Float32IsGoodToItsRounding) {
  constexpr double kHalfUnit = 6e-8;  // of float32, relative
  const TimeSeries series = test::sine(257);
  const TimeSeries back = decode_trace(encode_trace(series, TracePrecision::float32));
  EXPECT_LT(((back.samples - series.samples).array().abs() / (series.samples.array().abs() + 1e-30)).maxCoeff(),
            kHalfUnit);
}

TEST(TraceCodec, EvenTimesTakeTwoNumbersAndJitteringOnesAreKeptExactly) {
  TimeSeries series = test::sine(1000);
  for (Eigen::Index i = 0; i < 1000; ++i) series.times[i] = 0.25 + 0.0078125 * static_cast<double>(i);
  EXPECT_EQ(encode_trace(series, TracePrecision::float32).times.size(), 16U);
  series.times[500] += 1e-9;
  const EncodedTrace jittering = encode_trace(series, TracePrecision::float32);
  EXPECT_EQ(jittering.times.size(), 8000U);
  EXPECT_TRUE(decode_trace(jittering).times == series.times);
}

TEST(TraceCodec, ATraceOf1000By8Takes32Kilobytes) {
  TimeSeries series;
  series.times = Eigen::VectorXd::LinSpaced(1000, 0.0, 999.0);
  series.samples = TimeSeries::Samples::Zero(1000, 8);
  series.channels.resize(8);
  EXPECT_EQ(encode_trace(series, TracePrecision::float32).samples.size(), 32'000U);
}

TEST(TraceCodec, ShortAndEmptyTracesComeBack) {
  for (const int samples : {1, 2, 3}) {
    const TimeSeries series = test::sine(samples);
    EXPECT_TRUE(decode_trace(encode_trace(series, TracePrecision::float64)).times == series.times) << samples;
  }
  const TimeSeries empty = decode_trace(encode_trace(TimeSeries{}, TracePrecision::float32));
  EXPECT_EQ(empty.samples.size(), 0);
}

TEST(TraceCodec, AnyFlippedBitIsNoticed) {
  const EncodedTrace good = encode_trace(test::sine(4), TracePrecision::float32);
  const auto flip_each = [&](std::vector<std::byte> EncodedTrace::*part) {
    for (std::size_t bit = 0; bit < 8 * (good.*part).size(); ++bit) {
      EncodedTrace damaged = good;
      (damaged.*part)[bit / 8] ^= std::byte{1} << (bit % 8);
      EXPECT_THROW(decode_trace(damaged), Error);
    }
  };
  flip_each(&EncodedTrace::times);
  flip_each(&EncodedTrace::samples);
  EncodedTrace renamed = good;
  renamed.channels[10] = 'x';
  EXPECT_THROW(decode_trace(renamed), Error);
}

/// Its digest is right, whoever made it: it stands in a file that somebody else may have written.
TEST(TraceCodec, PartsThatDoNotFitTogetherAreRefused) {
  const auto message = [](const TimeSeries& series, const std::function<void(EncodedTrace&)>& change) {
    EncodedTrace trace = encode_trace(series, TracePrecision::float64);
    change(trace);
    trace.digest = digest_of(trace);
    return test::sentence_of([&] { decode_trace(trace); });
  };
  const TimeSeries series = test::sine(4);
  EXPECT_EQ(message(series, [](EncodedTrace&) {}), "no error");
  for (const std::int64_t count : {std::int64_t{-1}, std::int64_t{3}, std::int64_t{1} << 61})
    EXPECT_THAT(message(series, [&](EncodedTrace& trace) { trace.sample_count = count; }), HasSubstr("inconsistent"));
  EXPECT_THAT(message(series, [](EncodedTrace& trace) { trace.times.clear(); }), HasSubstr("inconsistent"));
  EXPECT_THAT(message(series, [](EncodedTrace& trace) { trace.samples.pop_back(); }), HasSubstr("inconsistent"));
  EXPECT_THAT(message(TimeSeries{}, [](EncodedTrace& trace) { trace.sample_count = std::int64_t{1} << 61; }),
              HasSubstr("inconsistent"));
  for (const char* channels : {"", "[", "[1]", "[{}]", R"([{"name": "a", "unit": 1}])"})
    EXPECT_THAT(message(series, [&](EncodedTrace& trace) { trace.channels = channels; }), HasSubstr("channels"));
  const std::string deep = std::string(80'000, '[') + std::string(80'000, ']');
  EXPECT_THAT(message(series, [&](EncodedTrace& trace) { trace.channels = deep; }), HasSubstr("channels"));
}

}  // namespace
}  // namespace lacuna
