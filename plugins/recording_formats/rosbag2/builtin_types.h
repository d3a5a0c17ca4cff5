#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lacuna::rosbag2 {

/// The definition of a common message as in its .msg file, by its plain name; several where it has changed, none where
/// it is unknown here. Bags of older ROS 2 do not contain the definitions of their messages.
std::vector<std::string_view> builtin_definitions(const std::string& name);

}  // namespace lacuna::rosbag2
