#include "config/schema/shape.h"

#include "config/toml/toml_node.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

std::string bounds(const Shape& shape) {
  const bool below = std::isfinite(shape.upper);
  if (std::isfinite(shape.lower) && below && !shape.above) return fmt::format(", {} to {}", shape.lower, shape.upper);
  std::string text;
  if (std::isfinite(shape.lower)) text += fmt::format(", {} {}", shape.above ? "above" : "at least", shape.lower);
  if (below) text += fmt::format(", at most {}", shape.upper);
  if (shape.may_be_infinite) text += ", or inf";
  return text;
}

std::string number_words(const Shape& shape) {
  if (shape.unit.empty()) return "a number, or a text with a unit" + bounds(shape);
  return (shape.unit == "1" ? "a number" : "a number in " + shape.unit) + bounds(shape);
}

std::string list_words(const Shape& shape) {
  std::string count = "a list";
  if (shape.fewest == shape.most)
    count += fmt::format(" of {}", shape.fewest);
  else if (shape.fewest > 0)
    count += fmt::format(" of at least {}", shape.fewest);
  return count + ", each " + described(shape.parts.front());
}

std::string text_words(const Shape& shape) {
  if (!shape.meaning.empty()) return shape.meaning;
  if (shape.choices.empty()) return "a text";
  std::vector<std::string> quoted;
  for (const std::string& choice : shape.choices) quoted.push_back(toml_text(choice));
  return one_of(quoted);
}

std::string kind_in_words(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::boolean: return "true or false";
    case Shape::Kind::integer: return "a whole number" + bounds(shape);
    case Shape::Kind::number: return number_words(shape);
    case Shape::Kind::text: return text_words(shape);
    case Shape::Kind::list: return list_words(shape);
    case Shape::Kind::table: return "a table";
    case Shape::Kind::named:
      if (shape.parts.front().kind == Shape::Kind::table) return "a table for each " + shape.name_hint;
      return "a table of " + shape.name_hint + " = " + described(shape.parts.front());
    case Shape::Kind::either: break;
  }
  std::vector<std::string> alternatives;
  for (const Shape& part : shape.parts) alternatives.push_back(described(part));
  return one_of(alternatives);
}

}  // namespace

Shape::Shape() = default;
Shape::Shape(const Shape&) = default;
Shape::Shape(Shape&&) noexcept = default;
Shape& Shape::operator=(const Shape&) = default;
Shape& Shape::operator=(Shape&&) noexcept = default;
Shape::~Shape() = default;

KeyShape::KeyShape(std::string_view key, Shape value, bool is_required, std::string standard, std::string_view meaning)
    : name(key),
      shape(std::move(value)),
      required(is_required),
      default_text(std::move(standard)),
      description(meaning) {}
KeyShape::KeyShape(const KeyShape&) = default;
KeyShape::KeyShape(KeyShape&&) noexcept = default;
KeyShape& KeyShape::operator=(const KeyShape&) = default;
KeyShape& KeyShape::operator=(KeyShape&&) noexcept = default;
KeyShape::~KeyShape() = default;

std::string described(const Shape& shape) {
  const bool is_said = shape.meaning.empty() || shape.kind == Shape::Kind::text;
  return is_said ? kind_in_words(shape) : kind_in_words(shape) + " (" + shape.meaning + ")";
}

std::string one_of(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

}  // namespace lacuna
