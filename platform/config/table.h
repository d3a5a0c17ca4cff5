#pragma once

#include "config/value.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// Says which of a table's keys are not declared, and which required ones are missing.
void check_keys(const Shape& shape, const TomlNode& node, Reading& reading);

/// Declares the keys of a table that is read into a `T`. Defaults are those of a fresh `T`.
///
///   Table<FitSection>()
///       .key("starts", &FitSection::starts, whole_number(1, 1000), "starting points")
///
/// A declaration is complete with its description: nothing about a key is said anywhere else.
template <class T>
class Table {
 public:
  template <class M>
  Table& required(const std::string& name, M T::*member, const Value<M>& value, const std::string& description) {
    return keep<M>(name, value, [member](T& object, M&& read) { object.*member = std::move(read); },
                   {name, value.shape, true, "", description});
  }

  template <class M>
  Table& key(const std::string& name, M T::*member, const Value<M>& value, const std::string& description) {
    return keep<M>(name, value, [member](T& object, M&& read) { object.*member = std::move(read); },
                   {name, value.shape, false, value.write(T{}.*member), description});
  }

  /// A key whose absence means something of its own.
  template <class M>
  Table& key(const std::string& name, std::optional<M> T::*member, const Value<M>& value,
             const std::string& description) {
    return keep<M>(name, value, [member](T& object, M&& read) { object.*member = std::move(read); },
                   {name, value.shape, false, "", description});
  }

  /// Keys that are not kept as they were read: `store` puts them away.
  template <class M>
  Table& required(const std::string& name, const Value<M>& value, std::function<void(T&, M&&)> store,
                  const std::string& description) {
    return keep<M>(name, value, std::move(store), {name, value.shape, true, "", description});
  }
  template <class M>
  Table& key(const std::string& name, const Value<M>& value, const M& standard, std::function<void(T&, M&&)> store,
             const std::string& description) {
    return keep<M>(name, value, std::move(store), {name, value.shape, false, value.write(standard), description});
  }

  /// A table in the file whose keys belong to this same object.
  Table& section(const std::string& name, const Table& keys, const std::string& description, bool required = false) {
    const Value<T> inner = keys.value();
    fields_.push_back({name, inner.read});
    shape_.keys.push_back({name, inner.shape, required, "", description});
    return *this;
  }

  /// The keys of another object, at this same level.
  template <class M>
  Table& merged(M T::*member, const Table<M>& keys) {
    for (const auto& field : keys.fields_)
      fields_.push_back({field.name, [read = field.read, member](const TomlNode& node, Reading& reading, T& object) {
                           return read(node, reading, object.*member);
                         }});
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

  struct Field {
    std::string name;
    std::function<bool(const TomlNode&, Reading&, T&)> read;
  };

  template <class M>
  Table& keep(const std::string& name, const Value<M>& value, std::function<void(T&, M&&)> store, KeyShape key) {
    fields_.push_back({name, [value, store](const TomlNode& node, Reading& reading, T& object) {
                         M read{};
                         const bool good = value.read(node, reading, read);
                         store(object, std::move(read));  // also with problems: its parts have names to check others by
                         return good;
                       }});
    shape_.keys.push_back(std::move(key));
    return *this;
  }

  bool read(const TomlNode& node, Reading& reading, T& object) const {
    if (!fits_table(shape_, node, reading)) return false;
    check_keys(shape_, node, reading);
    for (const Field& field : fields_) {
      const TomlNode* value = node.find(field.name);
      if (!value) continue;
      const Reading::Step step(reading, field.name);
      field.read(*value, reading, object);
    }
    for (const auto& check : checks_) check(node, reading, object);
    return !reading.is_troubled("");
  }

  static Shape empty_table() {
    Shape shape;
    shape.kind = Shape::Kind::table;
    return shape;
  }

  Shape shape_ = empty_table();
  std::vector<Field> fields_;
  std::vector<std::function<void(const TomlNode&, Reading&, T&)>> checks_;
};

}  // namespace lacuna
