#include "array_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>

namespace lacuna::numpy {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kLongestHeader = std::size_t{1} << 20;
constexpr std::size_t kDeepestType = 16;
constexpr std::size_t kMostDimensions = 32;
constexpr std::size_t kLargestElement = std::size_t{1} << 24;
constexpr const char* kAnew = "; write the file again with numpy.save or numpy.savez";

/// A Python literal of dictionaries, lists, tuples, texts, numbers and True or False, as used in headers.
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view text) : text_(text) {}

  ArrayHeader parse() {
    bool has_type = false, has_order = false, has_shape = false;
    expect('{');
    while (!take('}')) {
      const std::string key = text();
      expect(':');
      if (key == "descr" && !has_type) {
        has_type = true;
        header_.element_size = type("", 0, 0);
      } else if (key == "fortran_order" && !has_order) {
        has_order = true;
        header_.is_fortran_order = truth();
      } else if (key == "shape" && !has_shape) {
        has_shape = true;
        header_.shape = shape();
      } else {
        fail("has the key \"" + key.substr(0, 40) + "\"");
      }
      take(',');
    }
    skip_space();
    if (place_ < text_.size()) fail("has text after its end");
    if (!has_type || !has_order || !has_shape) fail("has no descr, fortran_order or shape");
    return std::move(header_);
  }

 private:
  [[noreturn]] static void fail(const std::string& what) {
    throw BadFile("its header " + what + ", which is not a header of an .npy file" + kAnew);
  }
  void skip_space() {
    while (place_ < text_.size() && std::strchr(" \t\n\r", text_[place_]) && text_[place_] != '\0') ++place_;
  }
  bool take(char wanted) {
    skip_space();
    if (place_ >= text_.size() || text_[place_] != wanted) return false;
    ++place_;
    return true;
  }
  bool sees(char wanted) {
    skip_space();
    return place_ < text_.size() && text_[place_] == wanted;
  }
  void expect(char wanted) {
    if (!take(wanted)) fail(std::string("has no ") + wanted + " at character " + std::to_string(place_ + 1));
  }
  std::string text() {
    skip_space();
    if (place_ < text_.size() && (text_[place_] == 'u' || text_[place_] == 'b')) ++place_;
    if (place_ >= text_.size() || (text_[place_] != '\'' && text_[place_] != '"'))
      fail("has no text at character " + std::to_string(place_ + 1));
    const char quote = text_[place_++];
    const std::size_t end = text_.find(quote, place_);
    if (end == text_.npos) fail("ends within a text");
    const std::string found(text_.substr(place_, end - place_));
    place_ = end + 1;
    return found;
  }
  bool truth() {
    skip_space();
    for (const std::string_view word : {"True", "False"})
      if (text_.substr(place_).starts_with(word)) {
        place_ += word.size();
        return word == "True";
      }
    fail("has neither True nor False");
  }
  std::uint64_t number() {
    skip_space();
    std::uint64_t value = 0;
    const char* const start = text_.data() + place_;
    const auto [stopped, error] = std::from_chars(start, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("has no whole number at character " + std::to_string(place_ + 1));
    place_ += static_cast<std::size_t>(stopped - start);
    take('L');
    return value;
  }
  std::vector<std::uint64_t> shape() {
    std::vector<std::uint64_t> sizes;
    expect('(');
    while (!take(')')) {
      if (sizes.size() == kMostDimensions) fail("has more than 32 dimensions");
      sizes.push_back(number());
      if (!take(',') && !sees(')')) fail("has no comma in a shape");
    }
    return sizes;
  }
  std::vector<std::uint64_t> shape_of_field() {
    if (sees('(')) return shape();
    return {number()};
  }

  /// Reads a type and adds its numbers; returns its size, bytes.
  std::size_t type(const std::string& path, std::size_t offset, std::size_t depth) {
    if (sees('[')) return structure(path, offset, depth);
    const std::string description = text();
    if (const auto scalar = scalar_type(description)) {
      add({path, offset, *scalar});
      return scalar->size;
    }
    if (description == "|O" || description == "O")
      throw BadFile(std::string("contains Python objects, which cannot be read; save arrays of numbers"));
    const auto size = size_of_type(description);
    if (!size) fail("has the type \"" + description.substr(0, 40) + "\"");
    const bool is_gap = path.empty() || path.back() == '.';
    if (!is_gap && header_.left_out.size() < kMostNumbers) header_.left_out.push_back(path);
    if (path.empty()) throw BadFile("contains no numbers but the type \"" + description.substr(0, 40) + "\"");
    return *size;
  }

  std::size_t structure(const std::string& path, std::size_t offset, std::size_t depth) {
    if (depth == kDeepestType) fail("nests its types too deeply");
    std::size_t size = 0;
    expect('[');
    while (!take(']')) {
      size += member(path, offset + size, depth);
      if (size > kLargestElement) fail("has elements of more than 16 MiB");
      take(',');
    }
    return size;
  }

  /// A field: ('name', type) or ('name', type, shape); the name may be ('title', 'name').
  std::size_t member(const std::string& path, std::size_t offset, std::size_t depth) {
    expect('(');
    std::string name;
    if (take('(')) {
      text();
      expect(',');
      name = text();
      expect(')');
    } else {
      name = text();
    }
    expect(',');
    const std::string inner = (path.empty() ? "" : path + ".") + name;
    const std::size_t first = header_.fields.size();
    std::size_t size = type(inner, offset, depth + 1);
    if (take(',') && !sees(')')) size = repeat(first, inner, offset, size, shape_of_field());
    expect(')');
    return size;
  }

  /// Repeats the fields since `first`, those of one element, for an array of that shape.
  std::size_t repeat(std::size_t first, const std::string& path, std::size_t offset, std::size_t size,
                     const std::vector<std::uint64_t>& sizes) {
    std::uint64_t count = 1;
    for (const std::uint64_t one : sizes)
      if (__builtin_mul_overflow(count, one, &count) || count * std::max<std::size_t>(size, 1) > kLargestElement)
        fail("has elements of more than 16 MiB");
    const std::vector<Field> one(header_.fields.begin() + static_cast<std::ptrdiff_t>(first), header_.fields.end());
    header_.fields.resize(first);
    if (count * one.size() > kMostNumbers) {
      header_.left_out.push_back(path);
      return count * size;
    }
    for (std::uint64_t i = 0; i < count; ++i)
      for (Field field : one) {
        field.path.insert(path.size(), indices(i, sizes));
        field.offset = offset + i * size + (field.offset - offset);
        add(std::move(field));
      }
    return count * size;
  }

  /// "[1][0]" for the third element of shape (2, 2).
  static std::string indices(std::uint64_t place, const std::vector<std::uint64_t>& sizes) {
    std::string text;
    for (std::size_t d = sizes.size(); d-- > 0; place /= sizes[d])
      text.insert(0, "[" + std::to_string(place % sizes[d]) + "]");
    return text;
  }

  void add(Field field) {
    if (header_.fields.size() == kMostNumbers) fail("has more than 4096 numbers per element");
    header_.fields.push_back(std::move(field));
  }

  std::string_view text_;
  std::size_t place_ = 0;
  ArrayHeader header_;
};

}  // namespace

std::size_t ArrayHeader::row_elements() const {
  std::uint64_t count = 1;
  for (std::size_t d = 1; d < shape.size(); ++d)
    if (__builtin_mul_overflow(count, shape[d], &count) || count > kMostNumbers) return 0;
  return static_cast<std::size_t>(count);
}

ArrayHeader parse_header(std::string_view text) { return HeaderParser(text).parse(); }

ArrayHeader read_header(ByteStream& stream) {
  std::array<unsigned char, 12> start{};
  const std::size_t got = stream.read(start.data(), 8);
  if (got < 8 || std::memcmp(start.data(), kMagic.data(), kMagic.size()) != 0)
    throw BadFile(std::string("is not an .npy file: it does not begin with \\x93NUMPY") + kAnew);
  const unsigned version = start[6];
  if (version < 1 || version > 3)
    throw BadFile("has version " + std::to_string(version) + " of the .npy format; only 1 to 3 can be read");
  const std::size_t width = version == 1 ? 2 : 4;
  std::size_t length = 0;
  if (stream.read(start.data() + 8, width) < width) throw BadFile("ends within its header; copy the file again");
  for (std::size_t i = width; i-- > 0;) length = length << 8 | start[8 + i];
  if (length > kLongestHeader)
    throw BadFile("states a header of " + std::to_string(length) + " bytes, more than 1 MiB" + kAnew);
  std::string text(length, '\0');
  if (stream.read(reinterpret_cast<unsigned char*>(text.data()), length) < length)
    throw BadFile("ends within its header; copy the file again");
  return parse_header(text);
}

}  // namespace lacuna::numpy
