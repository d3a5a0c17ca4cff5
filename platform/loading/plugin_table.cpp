#include "loading/plugin_table.h"

#include "loading/component_kinds.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>

namespace lacuna {
namespace {

constexpr const char* kRebuild = "; build it again with this program's headers, compiler and settings";

std::string known_kinds() {
  std::string kinds;
  for_each_component_kind([&]<class Interface>(std::type_identity<Interface>) {
    kinds += (kinds.empty() ? "" : ", ") + std::string(ComponentKind<Interface>::name);
  });
  return kinds;
}

std::string_view text_or_empty(const char* text) { return text == nullptr ? std::string_view() : text; }

std::string other_build(const std::string& what, std::string_view theirs, std::string_view ours) {
  return "was built with " + what + " \"" + std::string(theirs) + "\", this program with \"" + std::string(ours) +
         "\"" + kRebuild;
}

const TypeLayout* find_layout(std::span<const TypeLayout> layouts, std::string_view type) {
  const auto found = std::find_if(layouts.begin(), layouts.end(),
                                  [&](const TypeLayout& layout) { return text_or_empty(layout.type) == type; });
  return found == layouts.end() ? nullptr : &*found;
}

std::string size_text(const TypeLayout& layout) {
  return std::to_string(layout.size) + " bytes aligned to " + std::to_string(layout.alignment);
}

std::string layout_problem(std::span<const TypeLayout> layouts) {
  for (const TypeLayout& ours : kInterfaceLayouts) {
    const TypeLayout* theirs = find_layout(layouts, ours.type);
    if (theirs == nullptr) return "does not state the memory layout of " + std::string(ours.type) + kRebuild;
    if (theirs->size != ours.size || theirs->alignment != ours.alignment)
      return "lays out " + std::string(ours.type) + " in " + size_text(*theirs) + ", this program in " +
             size_text(ours) + kRebuild;
  }
  return {};
}

bool is_lower_snake(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// The beginning of the tables of all versions; the rest of another version's table is unknown, even its alignment.
struct TableHead {
  char magic[8];
  std::uint32_t interface_version;
};

std::string component_problem(std::span<const ComponentEntry> components) {
  if (components.empty()) return "has no components; name them in LACUNA_PLUGIN(...)";
  for (const ComponentEntry& component : components) {
    const std::string name(text_or_empty(component.name));
    if (component_noun(text_or_empty(component.kind)).empty())
      return "has a component \"" + name + "\" of the unknown kind \"" + std::string(text_or_empty(component.kind)) +
             "\"; this program knows " + known_kinds();
    if (!is_lower_snake(name)) return "has a component named \"" + name + "\"; use lower-case letters, digits and _";
    if (component.create == nullptr) return "has no factory for its component \"" + name + "\"" + kRebuild;
  }
  return {};
}

}  // namespace

std::string table_problem(const PluginTable* table) {
  TableHead head;
  if (table != nullptr) std::memcpy(&head, static_cast<const void*>(table), sizeof(head));
  if (table == nullptr || std::memcmp(head.magic, kPluginMagic, sizeof(kPluginMagic)) != 0)
    return std::string(kPluginSymbol) + " returns no plugin table; end one source file with LACUNA_PLUGIN(...)";
  if (head.interface_version != kInterfaceVersion)
    return "was built for version " + std::to_string(head.interface_version) +
           " of the plugin interface, this program has version " + std::to_string(kInterfaceVersion) + kRebuild;
  if (table->table_size != sizeof(PluginTable))
    return "has a plugin table of " + std::to_string(table->table_size) + " bytes, this program expects " +
           std::to_string(sizeof(PluginTable)) + kRebuild;
  if (text_or_empty(table->compiler) != LACUNA_COMPILER)
    return other_build("compiler", text_or_empty(table->compiler), LACUNA_COMPILER);
  if (text_or_empty(table->standard_library) != LACUNA_STANDARD_LIBRARY)
    return other_build("standard library", text_or_empty(table->standard_library), LACUNA_STANDARD_LIBRARY);
  if (table->layouts == nullptr || table->components == nullptr)
    return std::string("has an incomplete plugin table") + kRebuild;
  const std::string problem = layout_problem({table->layouts, table->layout_count});
  return problem.empty() ? component_problem({table->components, table->component_count}) : problem;
}

}  // namespace lacuna
