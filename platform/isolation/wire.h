#pragma once

#include <lacuna/error.h>
#include <lacuna/time_series.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lacuna {

/// Values as bytes for another process of the same program on the same machine. One function `carry(wire, value)` per
/// type lists its fields and serves both directions.
class WireWriter {
 public:
  static constexpr bool kReads = false;

  void bytes(void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// The inverse. Throws `Error` for bytes that end too early.
class WireReader {
 public:
  static constexpr bool kReads = true;

  explicit WireReader(std::string_view bytes) : left_(bytes) {}

  void bytes(void* data, std::size_t size) {
    if (size > left_.size()) throw Error("a message between two processes ends too early");
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }
  /// The number of elements that follow, each of which takes at least one byte.
  std::size_t count(std::uint64_t stated) const {
    if (stated > left_.size()) throw Error("a message between two processes ends too early");
    return static_cast<std::size_t>(stated);
  }

 private:
  std::string_view left_;
};

template <class Wire, class Number>
requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) void carry(Wire& wire, Number& number) {
  wire.bytes(&number, sizeof(number));
}

template <class Wire>
void carry(Wire& wire, bool& value) {
  std::uint8_t byte = value ? 1 : 0;
  carry(wire, byte);
  if (byte > 1) throw Error("a message between two processes has an invalid truth value");
  if constexpr (Wire::kReads) value = byte != 0;
}

/// The fields of a type, in this order.
template <class Wire, class... Parts>
void carry_all(Wire& wire, Parts&... parts) {
  (carry(wire, parts), ...);
}

/// Makes a container as long as the one that was written.
template <class Wire, class Container>
void carry_size(Wire& wire, Container& container) {
  std::uint64_t size = container.size();
  carry(wire, size);
  if constexpr (Wire::kReads) container.resize(wire.count(size));
}

template <class Wire>
void carry(Wire& wire, std::string& text) {
  carry_size(wire, text);
  wire.bytes(text.data(), text.size());
}

template <class Wire>
void carry(Wire& wire, std::filesystem::path& path) {
  std::string text = path.string();
  carry(wire, text);
  if constexpr (Wire::kReads) path = text;
}

template <class Wire>
void carry(Wire& wire, std::vector<double>& numbers) {
  std::uint64_t size = numbers.size();
  carry(wire, size);
  if constexpr (Wire::kReads) numbers.resize(wire.count(size));
  wire.bytes(numbers.data(), numbers.size() * sizeof(double));
}

template <class Wire, class Value>
void carry(Wire& wire, std::optional<Value>& value) {
  bool there = value.has_value();
  carry(wire, there);
  if constexpr (Wire::kReads) value = there ? std::optional<Value>(Value{}) : std::nullopt;
  if (value) carry(wire, *value);
}

template <class Wire, class Value>
void carry(Wire& wire, std::vector<Value>& values) {
  carry_size(wire, values);
  for (Value& value : values) carry(wire, value);
}

template <class Wire>
void carry(Wire& wire, Channel& channel) {
  carry_all(wire, channel.name, channel.unit);
}

/// A matrix or a column.
template <class Wire, class Matrix>
void carry_matrix(Wire& wire, Matrix& matrix) {
  auto rows = static_cast<std::uint64_t>(matrix.rows()), columns = static_cast<std::uint64_t>(matrix.cols());
  carry(wire, rows);
  carry(wire, columns);
  if constexpr (Wire::kReads) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();  // their product might overflow
    const bool is_column = Matrix::ColsAtCompileTime == 1;
    if (rows > kMost || columns > kMost || (is_column && columns != 1))
      throw Error("a message between two processes has an invalid size");
    wire.count(rows * columns);
    matrix.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  }
  wire.bytes(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double));
}

template <class Wire>
void carry(Wire& wire, TimeSeries& series) {
  carry(wire, series.channels);
  carry_matrix(wire, series.times);
  carry_matrix(wire, series.samples);
}

template <class Value>
std::string to_bytes(const Value& value) {
  WireWriter writer;
  carry(writer, const_cast<Value&>(value));  // writing changes nothing
  return writer.take();
}

template <class Value>
Value from_bytes(std::string_view bytes) {
  WireReader reader(bytes);
  Value value{};
  carry(reader, value);
  return value;
}

}  // namespace lacuna
