#pragma once

#include "config/edits/text_edit.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A list in brackets, as it stands in TOML text.
class BracketList {
 public:
  /// `text[at]` is the opening bracket of a list that TOML accepts. Throws `Error` where it is none.
  BracketList(std::string_view text, std::size_t at);

  std::size_t size() const { return items_.size(); }
  /// The text with `item` at the end of the list, laid out as the last one is.
  std::string with(const std::string& item) const;
  /// The text without the item at `index`.
  std::string without(std::size_t index) const;

 private:
  struct Item {
    Span span;
    std::optional<std::size_t> comma;  ///< behind it
  };

  std::string with_first(const std::string& item) const;
  bool begins_its_line(const Item& item) const;
  /// Whether nothing but a comment follows it and its comma.
  bool ends_its_line(const Item& item) const;

  std::string_view text_;
  Span inside_;  ///< between the brackets
  std::vector<Item> items_;
};

}  // namespace lacuna
