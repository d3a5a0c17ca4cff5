#include "element_names.h"

#include <cctype>

namespace lacuna::robot_files {
namespace {

bool is_of_names(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

}  // namespace

std::string ElementNames::named(std::string_view what, const std::string& written, int line, const std::string& file,
                                std::vector<RobotRemark>& remarks) {
  auto& known = named_[std::string(what)];
  if (const auto found = known.find(written); found != known.end()) return found->second;
  std::string name = written;
  for (char& c : name)
    if (!is_of_names(c)) c = '_';
  if (name == kWorld && what == "body") name = "world_body";
  name = new_name(what, name);
  if (name != written)
    remarks.push_back({RobotRemarkKind::repaired, line,
                       std::string(what) + " \"" + written + "\" gets the name " + name +
                           ": names consist of letters, digits, _ and - only and must differ",
                       file});
  return known[written] = name;
}

bool ElementNames::is_taken(std::string_view what, const std::string& name) const {
  const auto of_kind = taken_.find(what);
  return of_kind != taken_.end() && of_kind->second.contains(name);
}

std::string ElementNames::new_name(std::string_view what, const std::string& name) {
  auto& taken = taken_[std::string(what)];
  const auto [first, is_new] = taken.emplace(name, 1);
  if (is_new) return name;
  std::string numbered;
  do numbered = name + "_" + std::to_string(++first->second);
  while (taken.contains(numbered));
  taken.emplace(numbered, 1);
  return numbered;
}

}  // namespace lacuna::robot_files
