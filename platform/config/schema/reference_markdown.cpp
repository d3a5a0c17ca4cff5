#include "config/schema/reference.h"

#include <algorithm>

namespace lacuna {
namespace {

struct Section {
  std::string heading;
  std::string description;
  const Shape* table = nullptr;
  const Shape* named = nullptr;  ///< of a section whose keys the user chooses
};

std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\t' ? std::string("\\t") : std::string(1, c);
  }
  return escaped;
}

struct TablePlace {
  const Shape* table = nullptr;  ///< null: there is none
  std::string path;
};

/// The table that stands somewhere in the shape, and its path.
TablePlace table_within(const Shape& shape, std::string path) {
  if (shape.kind == Shape::Kind::table) return {&shape, path};
  if (shape.kind == Shape::Kind::named) path += "." + shape.name_hint;
  if (shape.kind == Shape::Kind::list) path += "[]";
  for (const Shape& part : shape.parts)
    if (TablePlace place = table_within(part, path); place.table) return place;
  return {};
}

/// Whether all that may stand there is one table, so that the section says more than a row could.
bool is_table_only(const Shape& shape) {
  if (shape.kind == Shape::Kind::table) return true;
  const bool holds_one = shape.kind == Shape::Kind::named || shape.kind == Shape::Kind::list;
  return holds_one && is_table_only(shape.parts.front());
}

std::string row(const KeyShape& key) {
  const std::string standard = key.required                                             ? "required"
                               : key.default_text.empty() || key.default_text == "\"\"" ? ""
                                                                                        : "`" + key.default_text + "`";
  return "| `" + key.name + "` | " + cell(described(key.shape)) + " | " + cell(standard) + " | " +
         cell(key.description) + " |\n";
}

/// In TOML a list of tables is named without brackets of its own.
std::string heading_of(std::string path, const Shape& shape) {
  if (shape.kind != Shape::Kind::list) return "`[" + path + "]`";
  for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]")) path.erase(at, 2);
  return "`[[" + path + "]]`";
}

void collect(const Shape& table, const std::string& path, std::vector<Section>& sections) {
  for (const KeyShape& key : table.keys) {
    const TablePlace place = table_within(key.shape, path.empty() ? key.name : path + "." + key.name);
    if (!place.table && path.empty())
      sections.push_back({heading_of(key.name, key.shape), key.description, nullptr, &key.shape});
    if (!place.table) continue;
    if (is_table_only(key.shape))
      sections.push_back({heading_of(place.path, key.shape), key.description, place.table});
    else
      sections.push_back({"`" + place.path + "` as a table", "", place.table});
    collect(*place.table, place.path, sections);
  }
}

std::string section_text(const Section& section) {
  std::string text = "\n## " + section.heading + "\n\n";
  if (!section.description.empty()) text += section.description + "\n\n";
  std::string rows;
  if (section.named) rows = row({section.named->name_hint, section.named->parts.front(), false, "", ""});
  if (section.table)
    for (const KeyShape& key : section.table->keys)
      if (!is_table_only(key.shape)) rows += row(key);
  if (rows.empty()) return section.description.empty() ? "" : text;
  return text + "| key | value | default | meaning |\n| --- | --- | --- | --- |\n" + rows;
}

}  // namespace

std::string markdown_reference(const Shape& file, const ReferenceHead& head) {
  std::vector<Section> sections;
  collect(file, "", sections);
  std::string text = "# " + head.title + "\n\n<!-- Made from the declaration of keys by `" + head.regenerate +
                     "`; a test compares them. -->\n\n" + head.introduction;
  for (const Section& section : sections) text += section_text(section);
  return text;
}

}  // namespace lacuna
