#pragma once

#include <set>
#include <string>

namespace lacuna {

/// The text with a "-" for whatever may trouble a shell or a file system.
std::string file_name(const std::string& text);

/// Names of the files that one command puts into one folder. No two are equal: where `file_name` maps a text to a name
/// that another has, the second gets a number before its ending, as in `a-b-2.svg`. Names that are too
/// long for a file system are cut before their ending.
class FileNames {
 public:
  std::string next(const std::string& text);

 private:
  std::set<std::string> taken_;
};

}  // namespace lacuna
