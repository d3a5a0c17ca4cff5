#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

struct KeyShape;

/// What may stand at a place in a file, as data: the one declaration from which validation,
/// reading, the reference page and the JSON Schema come.
struct Shape {
  enum class Kind {
    boolean,
    integer,
    number,  ///< a number in `unit`, or a text such as "120 mm"
    text,
    list,   ///< of `parts[0]`
    table,  ///< with `keys`
    named,  ///< a table whose keys the user chooses (`name_hint`), each with `parts[0]`
    either  ///< whichever of `parts` fits
  };

  // Made, copied and destroyed in one place, and not wherever a declaration is: half of the time to compile this room.
  Shape();
  Shape(const Shape&);
  Shape(Shape&&) noexcept;
  Shape& operator=(const Shape&);
  Shape& operator=(Shape&&) noexcept;
  ~Shape();

  Kind kind = Kind::text;
  std::string unit;  ///< number: SI; "" where it depends on what the number belongs to; "N*m or N" where on the joint
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool above = false;  ///< the lower bound itself is excluded
  bool may_be_infinite = false;
  std::vector<std::string> choices;  ///< text: these and no others
  std::size_t fewest = 0;            ///< list: items; text: characters
  std::size_t most = std::numeric_limits<std::size_t>::max();
  std::string name_hint;
  std::string meaning;  ///< "a file that exists", "x, y, z in the world": what the kind alone does not say
  std::vector<Shape> parts;
  std::vector<KeyShape> keys;
};

struct KeyShape {
  KeyShape(std::string_view key, Shape value, bool is_required, std::string standard, std::string_view meaning);
  KeyShape(const KeyShape&);
  KeyShape(KeyShape&&) noexcept;
  KeyShape& operator=(const KeyShape&);
  KeyShape& operator=(KeyShape&&) noexcept;
  ~KeyShape();

  std::string name;
  Shape shape;
  bool required = false;
  std::string default_text;  ///< as TOML; empty: none
  std::string description;   ///< a sentence without its full stop, or a noun phrase
};

/// The shape in words, such as "a number in kg, above 0" or "\"zero\" or \"first\"".
std::string described(const Shape& shape);

/// Words put together: "a", "a or b", "a, b or c".
std::string one_of(const std::vector<std::string>& words);

}  // namespace lacuna
