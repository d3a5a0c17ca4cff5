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

/// How often a field's value stands in a message.
enum class Times {
  once,
  fixed,    ///< so often as the type says
  sequence  ///< as often as the message says
};

struct MessageField {
  std::string name;
  Primitive primitive = Primitive::none;
  std::size_t type = 0;  ///< of a field without a primitive: index of its type
  Times times = Times::once;
  std::size_t count = 1;  ///< of a fixed number
};

struct MessageType {
  std::string name;  ///< "geometry_msgs/Vector3"
  std::vector<MessageField> fields;
};

/// A message's type and those that it is made of. None contains itself.
struct MessageTypes {
  std::vector<MessageType> types;  ///< the message's own first
};

/// Bytes of a primitive; of a text 4, its length.
std::size_t size_of(Primitive primitive);

/// "geometry_msgs/Vector3" of "geometry_msgs/msg/Vector3".
std::string plain_type_name(std::string_view name);

/// Types of the definition of `root` in .msg files, with those that it needs behind lines of `=` and "MSG: name". Types
/// that are missing there are taken from those built in (builtin_types.h). Throws `BadBag`.
MessageTypes parse_definition(const std::string& root, std::string_view text);

/// The same of a type that is built in; several where its definition has changed. Throws `BadBag` for any other.
std::vector<MessageTypes> known_types(const std::string& root);

}  // namespace lacuna::rosbag2
