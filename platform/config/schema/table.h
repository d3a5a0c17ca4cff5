#pragma once

#include "config/schema/value.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lacuna {

/// Says which of a table's keys are not declared, and which required ones are missing.
void check_keys(const Shape& shape, const TomlNode& node, Reading& reading);

/// The part of a `Table` that does not depend on what is read; out of line, for there are hundreds of keys.
class TableShape {
 protected:
  TableShape();
  void declare(std::string_view name, const Shape& value, bool required, std::string default_text,
               std::string_view description);
  /// The value of a declared key; null where the table in the file does not have it.
  const TomlNode* find(const TomlNode& node, std::size_t key) const;

  Shape shape_;
};

/// Declares the keys of a table that is read into a `T`. Defaults are those of a fresh `T`.
///
///   Table<FitSection>()
///       .key("starts", &FitSection::starts, whole_number(1, 1000), "starting points")
///
/// A declaration is complete with its description: nothing about a key is said anywhere else.
template <class T>
class Table : private TableShape {
 public:
  template <class M>
  Table& required(std::string_view name, M T::*member, const Value<M>& value, std::string_view description) {
    declare(name, value.shape, true, "", description);
    return read_into<M>(value, [member](T& object, M&& read) { object.*member = std::move(read); });
  }

  template <class M>
  Table& key(std::string_view name, M T::*member, const Value<M>& value, std::string_view description) {
    declare(name, value.shape, false, value.write(fresh().*member), description);
    return read_into<M>(value, [member](T& object, M&& read) { object.*member = std::move(read); });
  }

  /// A key whose absence means something of its own.
  template <class M>
  Table& key(std::string_view name, std::optional<M> T::*member, const Value<M>& value, std::string_view description) {
    declare(name, value.shape, false, "", description);
    return read_into<M>(value, [member](T& object, M&& read) { object.*member = std::move(read); });
  }

  /// Keys that are not kept as they were read: `store` puts them away.
  template <class M>
  Table& required(std::string_view name, const Value<M>& value, std::function<void(T&, M&&)> store,
                  std::string_view description) {
    declare(name, value.shape, true, "", description);
    return read_into<M>(value, std::move(store));
  }
  template <class M>
  Table& key(std::string_view name, const Value<M>& value, const M& standard, std::function<void(T&, M&&)> store,
             std::string_view description) {
    declare(name, value.shape, false, value.write(standard), description);
    return read_into<M>(value, std::move(store));
  }

  /// A table in the file whose keys belong to this same object.
  Table& section(std::string_view name, const Table& keys, std::string_view description, bool required = false) {
    const Value<T> inner = keys.value();
    declare(name, inner.shape, required, "", description);
    fields_.push_back(inner.read);
    return *this;
  }

  /// The keys of another object, at this same level.
  template <class M>
  Table& merged(M T::*member, const Table<M>& keys) {
    for (const auto& field : keys.fields_)
      fields_.push_back([field, member](const TomlNode& node, Reading& reading, T& object) {
        return field(node, reading, object.*member);
      });
    for (const auto& check : keys.checks_)
      checks_.push_back(
          [check, member](const TomlNode& node, Reading& reading, T& object) { check(node, reading, object.*member); });
    shape_.keys.insert(shape_.keys.end(), keys.shape_.keys.begin(), keys.shape_.keys.end());
    return *this;
  }

  /// Remembers where the table stands.
  Table& located(SourceLocation T::*member) {
    return check({}, [member](const TomlNode& node, Reading&, T& object) { object.*member = node.location; });
  }

  /// What concerns several keys at once; left out where one of `keys` has a problem already.
  Table& check(const std::vector<std::string>& keys, std::function<void(const TomlNode&, Reading&, T&)> check) {
    checks_.push_back([keys, check](const TomlNode& node, Reading& reading, T& object) {
      for (const std::string& key : keys)
        if (reading.is_troubled(key)) return;
      check(node, reading, object);
    });
    return *this;
  }

  Value<T> value() const {
    Value<T> value;
    value.shape = shape_;
    value.read = [*this](const TomlNode& node, Reading& reading, T& object) { return read(node, reading, object); };
    value.write = [](const T&) { return std::string(); };
    return value;
  }

 private:
  template <class Other>
  friend class Table;

  using Field = std::function<bool(const TomlNode&, Reading&, T&)>;

  template <class M>
  Table& read_into(const Value<M>& value, std::function<void(T&, M&&)> store) {
    fields_.push_back(
        [read_value = value.read, store = std::move(store)](const TomlNode& node, Reading& reading, T& object) {
          M read{};
          const bool good = read_value(node, reading, read);
          store(object, std::move(read));  // also with problems: its parts have names to check others by
          return good;
        });
    return *this;
  }

  /// What has the defaults.
  static const T& fresh() {
    static const T object{};
    return object;
  }

  bool read(const TomlNode& node, Reading& reading, T& object) const {
    if (!fits_table(shape_, node, reading)) return false;
    check_keys(shape_, node, reading);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const TomlNode* value = find(node, i);
      if (!value) continue;
      const Reading::Step step(reading, shape_.keys[i].name);
      fields_[i](*value, reading, object);
    }
    for (const auto& check : checks_) check(node, reading, object);
    return !reading.is_troubled("");
  }

  std::vector<Field> fields_;  ///< by key of the shape
  std::vector<std::function<void(const TomlNode&, Reading&, T&)>> checks_;
};

}  // namespace lacuna
