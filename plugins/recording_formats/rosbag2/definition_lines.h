#pragma once

#include "message_types.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::rosbag2 {

/// A field of a .msg file. Without a primitive, `type` is the written type: "Vector3", "geometry_msgs/Vector3".
struct DefinitionLine {
  MessageField field;
  std::string type;
};

/// The fields of one .msg file; constants, comments and default values are skipped. Throws `BadBag`.
std::vector<DefinitionLine> lines_of_definition(std::string_view text);

/// The .msg files in a text with several, by type: the first is that of `root`.
std::map<std::string, std::string_view> split_definitions(const std::string& root, std::string_view text);

}  // namespace lacuna::rosbag2
