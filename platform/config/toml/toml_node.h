#pragma once

#include "foundation/text/problem.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

struct TomlMember;

/// A value of a TOML file together with its place: our own copy of what the parser found, in which
/// every value keeps its place in the file whatever overrides are put beside it.
struct TomlNode {
  enum class Kind { boolean, integer, real, text, date, list, table };

  Kind kind = Kind::table;
  bool boolean = false;
  std::int64_t integer = 0;
  double real = 0.0;
  std::string text;                 ///< of a text
  std::vector<TomlNode> items;      ///< of a list
  std::vector<TomlMember> members;  ///< of a table, in the order of the file
  SourceLocation location;          ///< first character; a table's header or brace
  SourceLocation end;               ///< one past the last character of a value written in one piece

  /// The member called `name`, or null.
  const TomlNode* find(std::string_view name) const;
  TomlNode* find(std::string_view name);
  bool is_number() const { return kind == Kind::integer || kind == Kind::real; }
};

struct TomlMember {
  std::string name;
  SourceLocation location;  ///< of the key
  TomlNode value;
};

/// "a number", "a text", "a table" ..., as messages say it.
std::string_view described(TomlNode::Kind kind);

/// Whether two trees hold the same values under the same keys, wherever they stand.
bool same_values(const TomlNode& a, const TomlNode& b);

/// `key` as it stands in a TOML file: bare where it may be, quoted otherwise.
std::string toml_key(std::string_view key);
/// `text` as a TOML string; a double as a TOML number that reads back as the same value.
std::string toml_text(std::string_view text);
std::string toml_number(double value);
/// Each line of `text` as a comment.
std::string toml_comment(const std::string& text);

}  // namespace lacuna
