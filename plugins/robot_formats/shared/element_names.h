#pragma once

#include <lacuna/robot_format.h>

#include <map>
#include <string>
#include <string_view>

namespace lacuna::robot_files {

/// Names of the program have letters, digits, _ and -; others become some. The same name becomes the same.
class ElementNames {
 public:
  /// `what` is the kind, "joint": two of one kind that would become one are told apart by _2, _3.
  std::string named(std::string_view what, const std::string& written, int line, const std::string& file,
                    std::vector<RobotRemark>& remarks);

  /// Whether a name is taken by one of that kind.
  bool is_taken(std::string_view what, const std::string& name) const;
  /// `name`, or with _2, _3 behind it where that is taken; taken from then on.
  std::string new_name(std::string_view what, const std::string& name);

 private:
  std::map<std::string, std::map<std::string, std::string>, std::less<>> named_;  ///< kind, written → name
  std::map<std::string, std::map<std::string, int>, std::less<>> taken_;          ///< kind, name → last number
};

}  // namespace lacuna::robot_files
