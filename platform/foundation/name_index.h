#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace lacuna {

/// Index of names in a list, for many look-ups in a long one. The list must outlive it unchanged.
class NameIndex {
 public:
  NameIndex() = default;
  template <class List, class NameOf>
  NameIndex(const List& list, NameOf&& name_of) {
    std::size_t place = 0;
    for (const auto& one : list) {
      const auto [entry, is_new] = places_.try_emplace(name_of(one), Found{place, 0});
      ++entry->second.count;
      ++place;
    }
  }
  template <class List>
  explicit NameIndex(const List& names)
      : NameIndex(names, [](const std::string& name) { return std::string_view(name); }) {}

  /// The first of that name.
  std::optional<std::size_t> find(std::string_view name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? std::nullopt : std::optional(found->second.first);
  }
  /// How many have that name.
  std::size_t count(std::string_view name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? 0 : found->second.count;
  }

 private:
  struct Found {
    std::size_t first, count;
  };
  std::unordered_map<std::string_view, Found> places_;
};

}  // namespace lacuna
