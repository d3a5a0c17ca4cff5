#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::rosbag2 {

enum class Primitive {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  text,
  none
};

/// How often a field's value occurs in a message.
enum class Times {
  once,
  fixed,    ///< a fixed number of times, from the type
  sequence  ///< a number of times stated in the message
};

struct MessageField {
  std::string name;
  Primitive primitive = Primitive::none;
  std::size_t type = 0;  ///< for a field without a primitive: index of its type
  Times times = Times::once;
  std::size_t count = 1;  ///< for a fixed number
};

struct MessageType {
  std::string name;  ///< "geometry_msgs/Vector3"
  std::vector<MessageField> fields;
};

/// A message's type and the types that it contains. None contains itself.
struct MessageTypes {
  std::vector<MessageType> types;  ///< the message's own first
};

/// Bytes of a primitive; for a text 4, its length.
std::size_t size_of(Primitive primitive);

/// "geometry_msgs/Vector3" of "geometry_msgs/msg/Vector3".
std::string plain_type_name(std::string_view name);

/// Types of the definition of `root` in .msg files, with those that it needs after lines of `=` and "MSG: name".
/// Missing types are taken from the built-in ones (builtin_types.h). Throws `BadBag`.
MessageTypes parse_definition(const std::string& root, std::string_view text);

/// The same for a built-in type; several where its definition has changed. Throws `BadBag` for any other.
std::vector<MessageTypes> known_types(const std::string& root);

}  // namespace lacuna::rosbag2
