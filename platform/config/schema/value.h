#pragma once

#include "config/toml/reading.h"
#include "config/schema/shape.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lacuna {

/// How a `T` is written in a file: allowed values, how it is read, and how a default is shown.
template <class T>
struct Value {
  Shape shape;
  /// Reads a node; where it does not fit, says so to `Reading` and returns false.
  std::function<bool(const TomlNode&, Reading&, T&)> read;
  /// The value as TOML; empty text where it has no simple form.
  std::function<std::string(const T&)> write;
};

/// A number with its unit in SI (`"1"`: none). "N*m or N" takes either, the joint's kind decides;
/// "" takes any unit. What it was written with is noted (`Reading::written_unit`) in these two cases.
class NumberValue : public Value<double> {
 public:
  explicit NumberValue(const std::string& unit);
  NumberValue above(double bound) const { return bounded(bound, shape.upper, true); }
  NumberValue at_least(double bound) const { return bounded(bound, shape.upper, false); }
  NumberValue between(double lower, double upper) const { return bounded(lower, upper, false); }
  NumberValue or_infinite() const;

 private:
  NumberValue bounded(double lower, double upper, bool above) const;
};
NumberValue number(const std::string& unit);

Value<bool> boolean();
Value<std::int64_t> integer(std::int64_t lower, std::int64_t upper);
/// A text of at least `fewest` characters.
Value<std::string> text(std::size_t fewest = 1);
Value<std::string> text_of(const std::vector<std::string>& choices);
/// A name that may stand in an address: letters, digits, `_` and `-`.
Value<std::string> element_name();
bool is_element_name(std::string_view word);
/// The path of a file that exists, variables such as `${LACUNA_DATA}` replaced.
Value<std::filesystem::path> existing_file();
/// The same of a recording, which may be a folder (foundation/recording_folder.h).
Value<std::filesystem::path> existing_recording();
/// x, y, z.
Value<Eigen::Vector3d> vector3(const std::string& unit);
/// `[lower, upper]`, in this order.
Value<std::pair<double, double>> range_of(const NumberValue& value);

/// Whether a node of this kind may be meant by the shape, before looking inside.
bool may_be(const Shape& shape, const TomlNode& node);
/// Says that `node` is not what the shape asks for.
void report_mismatch(const Shape& shape, const TomlNode& node, Reading& reading);
/// Checks kind and count of a list.
bool fits_list(const Shape& shape, const TomlNode& node, Reading& reading);
/// Says so where an address such as `body.arm.mass` was written without quotes, which makes tables of it.
bool is_unquoted_address(const Shape& shape, const TomlMember& member, Reading& reading);
/// Checks that a node is a table.
bool fits_table(const Shape& shape, const TomlNode& node, Reading& reading);

template <class E>
Value<E> choice(const std::vector<std::pair<std::string, E>>& names) {
  std::vector<std::string> words;
  words.reserve(names.size());
  for (const auto& [word, meaning] : names) words.push_back(word);
  Value<std::string> inner = text_of(words);
  Value<E> value;
  value.shape = inner.shape;
  value.read = [inner, names](const TomlNode& node, Reading& reading, E& result) {
    std::string word;
    if (!inner.read(node, reading, word)) return false;
    for (const auto& [name, meaning] : names)
      if (name == word) result = meaning;
    return true;
  };
  value.write = [names](const E& shown) -> std::string {
    for (const auto& [name, meaning] : names)
      if (meaning == shown) return toml_text(name);
    return "";
  };
  return value;
}

template <class T>
Value<std::vector<T>> list_of(const Value<T>& item, std::size_t fewest = 0) {
  Value<std::vector<T>> value;
  value.shape.kind = Shape::Kind::list;
  value.shape.parts = {item.shape};
  value.shape.fewest = fewest;
  value.read = [item, shape = value.shape](const TomlNode& node, Reading& reading, std::vector<T>& result) {
    bool good = fits_list(shape, node, reading);
    if (!good) return false;
    result.clear();
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Reading::Step step(reading, i);
      T element{};
      good = item.read(node.items[i], reading, element) && good;
      result.push_back(std::move(element));
    }
    return good;
  };
  value.write = [item](const std::vector<T>& shown) {
    std::string words;
    for (const T& element : shown) words += (words.empty() ? "" : ", ") + item.write(element);
    return "[" + words + "]";
  };
  return value;
}

/// One thing or a list of them.
template <class T>
Value<std::vector<T>> one_or_list_of(const Value<T>& item) {
  const Value<std::vector<T>> list = list_of(item);
  Value<std::vector<T>> value;
  value.shape.kind = Shape::Kind::either;
  value.shape.parts = {item.shape, list.shape};
  value.read = [item, list](const TomlNode& node, Reading& reading, std::vector<T>& result) {
    if (node.kind == TomlNode::Kind::list) return list.read(node, reading, result);
    result.assign(1, T{});
    return item.read(node, reading, result.front());
  };
  value.write = list.write;
  return value;
}

/// A table whose keys the user chooses; `name_hint` is how the reference calls such a key. `keep`
/// puts a name and its value into the result, in the order of the file.
template <class Container, class T>
Value<Container> named(const std::string& name_hint, const Value<T>& item,
                       std::function<void(Container&, const TomlMember&, T&&)> keep) {
  Value<Container> value;
  value.shape.kind = Shape::Kind::named;
  value.shape.name_hint = name_hint;
  value.shape.parts = {item.shape};
  value.read = [item, keep, shape = value.shape](const TomlNode& node, Reading& reading, Container& result) {
    if (!fits_table(shape, node, reading)) return false;
    bool good = true;
    for (const TomlMember& member : node.members) {
      const Reading::Step step(reading, member.name);
      if (is_unquoted_address(shape, member, reading)) {
        good = false;
        continue;
      }
      T element{};
      good = item.read(member.value, reading, element) && good;
      keep(result, member, std::move(element));  // also where it has problems, so that its name is known
    }
    return good;
  };
  value.write = [](const Container&) { return std::string(); };
  return value;
}

template <class T>
Value<std::map<std::string, T>> map_of(const std::string& name_hint, const Value<T>& item) {
  return named<std::map<std::string, T>, T>(
      name_hint, item, [](std::map<std::string, T>& result, const TomlMember& member, T&& element) {
        result[member.name] = std::move(element);
      });
}

/// Either form. The first form that fits the kind of node reads it.
template <class T>
Value<T> either(const Value<T>& first, const Value<T>& second) {
  Value<T> value;
  value.shape.kind = Shape::Kind::either;
  value.shape.parts = {first.shape, second.shape};
  value.read = [first, second, shape = value.shape](const TomlNode& node, Reading& reading, T& result) {
    if (may_be(first.shape, node)) return first.read(node, reading, result);
    if (may_be(second.shape, node)) return second.read(node, reading, result);
    report_mismatch(shape, node, reading);
    return false;
  };
  value.write = first.write;
  return value;
}

/// The same written form, read into another type.
template <class To, class From>
Value<To> mapped(
    const Value<From>& from, std::function<To(From&&)> convert,
    std::function<std::string(const To&)> write = [](const To&) { return std::string(); }) {
  Value<To> value;
  value.shape = from.shape;
  value.read = [from, convert](const TomlNode& node, Reading& reading, To& result) {
    From read{};
    if (!from.read(node, reading, read)) return false;
    result = convert(std::move(read));
    return true;
  };
  value.write = std::move(write);
  return value;
}

/// A whole number in any integer type that holds the bounds.
template <class T>
Value<T> whole_number(std::int64_t lower, std::int64_t upper) {
  const Value<std::int64_t> inner = integer(lower, upper);
  return mapped<T, std::int64_t>(
      inner, [](std::int64_t&& read) { return static_cast<T>(read); },
      [inner](const T& shown) { return inner.write(static_cast<std::int64_t>(shown)); });
}

}  // namespace lacuna
