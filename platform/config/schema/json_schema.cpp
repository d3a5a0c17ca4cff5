#include "config/schema/reference.h"

#include "config/toml/toml_parser.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

void put_bounds(const Shape& shape, Json& json) {
  if (std::isfinite(shape.lower)) json[shape.above ? "exclusiveMinimum" : "minimum"] = shape.lower;
  if (std::isfinite(shape.upper)) json["maximum"] = shape.upper;
}

Json schema_of(const Shape& shape);

Json number_schema(const Shape& shape) {
  Json plain = {{"type", "number"}};
  put_bounds(shape, plain);
  const Json quantity = {{"type", "string"}, {"description", "a number and its unit, such as \"120 mm\""}};
  return {{"anyOf", {plain, quantity}}};
}

Json list_schema(const Shape& shape) {
  Json json = {{"type", "array"}, {"items", schema_of(shape.parts.front())}};
  if (shape.fewest > 0) json["minItems"] = shape.fewest;
  if (shape.most != std::numeric_limits<std::size_t>::max()) json["maxItems"] = shape.most;
  return json;
}

/// A default as JSON; nothing where JSON has no such value (infinity).
Json default_of(const std::string& toml) {
  const TomlNode node = parse_toml("value = " + toml, "").members.front().value;
  switch (node.kind) {
    case TomlNode::Kind::boolean: return node.boolean;
    case TomlNode::Kind::integer: return node.integer;
    case TomlNode::Kind::real: return std::isfinite(node.real) ? Json(node.real) : Json();
    case TomlNode::Kind::text: return node.text;
    case TomlNode::Kind::list: {
      Json items = Json::array();
      for (const TomlNode& item : node.items)
        items.push_back(item.kind == TomlNode::Kind::text ? Json(item.text) : Json(item.real));
      return items;
    }
    case TomlNode::Kind::date:
    case TomlNode::Kind::table: break;
  }
  return Json();
}

Json table(const Shape& shape) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const KeyShape& key : shape.keys) {
    Json property = schema_of(key.shape);
    property["description"] = key.description;
    if (!key.default_text.empty()) {
      const Json standard = default_of(key.default_text);
      if (!standard.is_null()) property["default"] = standard;
    }
    properties[key.name] = property;
    if (key.required) required.push_back(key.name);
  }
  Json json = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) json["required"] = required;
  return json;
}

Json text_schema(const Shape& shape) {
  Json json = {{"type", "string"}};
  if (!shape.choices.empty()) json["enum"] = shape.choices;
  if (shape.choices.empty() && shape.fewest > 0) json["minLength"] = shape.fewest;
  return json;
}

Json schema_of(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::boolean: return {{"type", "boolean"}};
    case Shape::Kind::integer: {
      Json json = {{"type", "integer"}};
      put_bounds(shape, json);
      return json;
    }
    case Shape::Kind::number: return number_schema(shape);
    case Shape::Kind::text: return text_schema(shape);
    case Shape::Kind::list: return list_schema(shape);
    case Shape::Kind::table: return table(shape);
    case Shape::Kind::named: return {{"type", "object"}, {"additionalProperties", schema_of(shape.parts.front())}};
    case Shape::Kind::either: break;
  }
  Json alternatives = Json::array();
  for (const Shape& part : shape.parts) alternatives.push_back(schema_of(part));
  return {{"anyOf", alternatives}};
}

}  // namespace

std::string json_schema(const Shape& file, const std::string& title) {
  Json json = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  json.update(schema_of(file));
  return json.dump(2) + "\n";
}

}  // namespace lacuna
