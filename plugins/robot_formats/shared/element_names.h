#pragma once

#include <lacuna/robot_format.h>

#include <map>
#include <string>
#include <string_view>

namespace lacuna::robot_files {

/// Names of the program consist of letters, digits, _ and -; others are converted. Equal names stay equal.
class ElementNames {
 public:
  /// `what` is the kind, "joint": two of one kind that would get the same name are distinguished by _2, _3.
  std::string named(std::string_view what, const std::string& written, int line, const std::string& file,
                    std::vector<RobotRemark>& remarks);

  /// Whether a name is used by one of that kind.
  bool is_taken(std::string_view what, const std::string& name) const;
  /// `name`, or with _2, _3 after it where that is used; reserves it.
  std::string new_name(std::string_view what, const std::string& name);

 private:
  std::map<std::string, std::map<std::string, std::string>, std::less<>> named_;  ///< kind, written → name
  std::map<std::string, std::map<std::string, int>, std::less<>> taken_;          ///< kind, name → last number
};

}  // namespace lacuna::robot_files
