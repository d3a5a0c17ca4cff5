#include "config/robots/robot_writer.h"
#include "config/edits/section_edit.h"
#include "config/edits/text_edit.h"
#include "config/toml/toml_node.h"
#include "config/toml/toml_parser.h"
#include "config/toml/toml_scanner.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace lacuna {
namespace {

std::size_t offset_of_place(std::string_view text, const SourceLocation& place) {
  return offset_of(text, place.line, place.column);
}

Span span_of_value(std::string_view text, const TomlNode& value) {
  return {offset_of_place(text, value.location), offset_of_place(text, value.end)};
}

/// "body.arm.inertia.xx": the section [body.arm], its key `inertia`, and the component `xx`.
struct AddressParts {
  std::string kind, element, key, component;
};

AddressParts parts_of(const std::string& address) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= address.size();) {
    const std::size_t dot = std::min(address.find('.', at), address.size());
    words.push_back(address.substr(at, dot - at));
    at = dot + 1;
  }
  if (words.front() == "contact" || words.front() == "world") words.insert(words.begin() + 1, "");
  words.resize(4);
  return {words[0], words[1], words[2], words[3]};
}

std::size_t component_index(const std::string& component) {
  static const std::map<std::string, std::size_t> kIndices = {{"x", 0}, {"y", 1}, {"z", 2}};
  const auto found = kIndices.find(component);
  return found == kIndices.end() ? 3 : found->second;
}

/// Collects the edits of one file.
class ValueEditor {
 public:
  ValueEditor(const std::string& text, const RobotSpec& robot)
      : text_(text), robot_(robot), tree_(parse_toml(text, "")) {}

  void set(const std::string& address, double value) {
    const AddressParts parts = parts_of(address);
    const TomlNode* section = find_section(parts);
    if (!section) throw Error("there is no section for " + address);
    const TomlNode* node = section->find(parts.key);
    if (!node)
      add_key(*section, parts, value);
    else if (parts.component.empty())
      replace(*node, toml_number(value));
    else
      set_component(*node, parts, value);
  }

  std::string result() {
    for (const auto& [section, lines] : new_lines_) {
      const std::size_t end = end_of_section(text_, *section, tree_);
      std::string all;
      for (const auto& [key, line] : lines) all += line_end_of(text_) + line;
      edits_.push_back({{end, end}, all});
    }
    return edited(text_, std::move(edits_));
  }

 private:
  const TomlNode* find_section(const AddressParts& parts) const {
    const TomlNode* kind = tree_.find(parts.kind);
    return !kind || parts.element.empty() ? kind : kind->find(parts.element);
  }

  void replace(const TomlNode& node, const std::string& value) {
    edits_.push_back({span_of_value(text_, node), value});
  }

  void set_component(const TomlNode& node, const AddressParts& parts, double value) {
    if (parts.kind == "body" && parts.key == "inertia") return replace_inertia(node, body(parts).inertia);
    const std::size_t index = component_index(parts.component);
    if (node.kind == TomlNode::Kind::list && index < node.items.size())
      return replace(node.items[index], toml_number(value));
    if (const TomlNode* member = node.find(parts.component)) return replace(*member, toml_number(value));
    throw Error("the value " + parts.key + "." + parts.component + " has no place");
  }

  /// As a whole, however many of its numbers change.
  void replace_inertia(const TomlNode& node, const InertiaSpec& inertia) {
    if (!replaced_.insert(&node).second) return;
    const bool has_products = inertia.xy != 0.0 || inertia.xz != 0.0 || inertia.yz != 0.0;
    replace(node, node.kind == TomlNode::Kind::list && !has_products ? vector({inertia.xx, inertia.yy, inertia.zz})
                                                                     : inertia_toml(inertia));
  }

  const BodySpec& body(const AddressParts& parts) const {
    return *std::find_if(robot_.bodies.begin(), robot_.bodies.end(),
                         [&](const BodySpec& one) { return one.name == parts.element; });
  }

  void add_key(const TomlNode& section, const AddressParts& parts, double value) {
    if (text_[offset_of_place(text_, section.location)] != '[') throw Error("a section is written in braces");
    auto& lines = new_lines_[&section];
    if (parts.kind == "body" && parts.key == "inertia")
      lines["inertia"] = "inertia = " + inertia_toml(body(parts).inertia);
    else if (parts.kind == "body" && parts.key == "com")
      lines["com"] = "com = " + vector(body(parts).com);
    else if (parts.key == "gravity")
      lines["gravity"] = "gravity = " + vector(robot_.gravity);
    else {
      const std::string key = parts.key + (parts.component.empty() ? "" : "." + parts.component);
      lines[key] = key + " = " + toml_number(value);
    }
  }

  static std::string vector(const Eigen::Vector3d& v) {
    return fmt::format("[{}, {}, {}]", toml_number(v.x()), toml_number(v.y()), toml_number(v.z()));
  }

  const std::string& text_;
  const RobotSpec& robot_;
  TomlNode tree_;
  std::vector<TextEdit> edits_;
  std::set<const TomlNode*> replaced_;
  std::map<const TomlNode*, std::map<std::string, std::string>> new_lines_;
};

}  // namespace

std::string with_robot_values(const std::string& text, const RobotSpec& robot,
                              const std::vector<std::pair<std::string, double>>& values) {
  ValueEditor editor(text, robot);
  for (const auto& [address, value] : values) editor.set(address, value);
  return editor.result();
}

}  // namespace lacuna
