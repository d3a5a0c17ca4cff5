#include "config/toml/locations.h"

namespace lacuna {
namespace {

void collect(const TomlNode& node, const std::string& path, Locations& locations) {
  if (!path.empty()) locations[path] = node.location;
  for (std::size_t i = 0; i < node.items.size(); ++i)
    collect(node.items[i], path + "[" + std::to_string(i) + "]", locations);
  for (const TomlMember& member : node.members)
    collect(member.value, path.empty() ? member.name : path + "." + member.name, locations);
}

}  // namespace

Locations locations_of(const TomlNode& tree) {
  Locations locations;
  collect(tree, "", locations);
  return locations;
}

SourceLocation nearest_location(const Locations& locations, std::string key, const std::string& file) {
  while (!key.empty()) {
    const auto found = locations.find(key);
    if (found != locations.end()) return found->second;
    const std::size_t end = key.find_last_of(".[");
    key.resize(end == std::string::npos ? 0 : end);
  }
  return {file, 0, 0};
}

}  // namespace lacuna
