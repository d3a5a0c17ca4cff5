#include "config/overrides.h"

#include "config/toml/toml_parser.h"
#include "config/toml/toml_scanner.h"

#include <charconv>
#include <optional>

namespace lacuna {
namespace {

constexpr std::size_t kDeepest = 32;

/// One step of a path: a key, or an index into a list.
struct PathStep {
  std::string key;
  std::optional<std::size_t> index;
};

/// Reads a path up to its '='.
class PathReader {
 public:
  explicit PathReader(const std::string& text) : text_(text) {}

  std::vector<PathStep> read() {
    std::vector<PathStep> steps = {key()};
    while (at_ < text_.size() && text_[at_] != '=') {
      if (text_[at_] == '.') {
        ++at_;
        steps.push_back(key());
      } else if (text_[at_] == '[') {
        steps.push_back(index());
      } else {
        throw Error("write the path as keys joined by dots, as in engine.step");
      }
      if (steps.size() > kDeepest) throw Error("the path is too long");
    }
    if (at_ >= text_.size()) throw Error("write KEY=VALUE, as in engine.step=0.0005");
    return steps;
  }

  std::string value() const { return text_.substr(at_ + 1); }

 private:
  PathStep key() {
    if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\'')) return quoted_key();
    const std::size_t end = std::min(text_.find_first_of(".[=\"'", at_), text_.size());
    PathStep step{text_.substr(at_, end - at_), std::nullopt};
    if (step.key.empty()) throw Error("a key is empty; write KEY=VALUE, as in engine.step=0.0005");
    at_ = end;
    return step;
  }

  PathStep quoted_key() {
    const std::size_t end = skip_string(text_, at_);
    const TomlNode parsed = parse_toml("key = " + text_.substr(at_, end - at_), "");
    at_ = end;
    return {parsed.members.front().value.text, std::nullopt};
  }

  PathStep index() {
    PathStep step{"", 0};
    const auto [end, error] = std::from_chars(text_.data() + at_ + 1, text_.data() + text_.size(), *step.index);
    at_ = static_cast<std::size_t>(end - text_.data());
    if (error != std::errc() || at_ >= text_.size() || text_[at_] != ']')
      throw Error("write an index as a number in brackets, as in model.effects[0]");
    ++at_;
    return step;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

TomlNode text_node(const std::string& text) {
  TomlNode node;
  node.kind = TomlNode::Kind::text;
  node.text = text;
  return node;
}

TomlNode parsed_value(const std::string& text) {
  try {
    TomlNode tree = parse_toml("value = " + text, "");
    if (tree.members.size() == 1 && tree.members.front().name == "value") return tree.members.front().value;
  } catch (const BadInput&) {
    if (!text.empty() && text.find_first_of("\"'[]{}\n") == std::string::npos) return text_node(text);
  }
  throw Error("\"" + text + "\" is not a TOML value");
}

void place(TomlNode& node, const SourceLocation& location) {
  node.location = location;
  for (TomlNode& item : node.items) place(item, location);
  for (TomlMember& member : node.members) {
    member.location = location;
    place(member.value, location);
  }
}

TomlNode& item_of(TomlNode& node, std::size_t index) {
  if (node.kind != TomlNode::Kind::list) throw Error("[" + std::to_string(index) + "] does not follow a list");
  if (index >= node.items.size())
    throw Error("there is no item [" + std::to_string(index) + "]; the list has " + std::to_string(node.items.size()));
  return node.items[index];
}

TomlNode& member_of(TomlNode& node, const std::string& key, const SourceLocation& location) {
  if (node.kind != TomlNode::Kind::table)
    throw Error("\"" + key + "\" does not follow a table, but " + std::string(described(node.kind)));
  if (TomlNode* found = node.find(key)) return *found;
  TomlNode table;
  place(table, location);
  node.members.push_back({key, location, table});
  return node.members.back().value;
}

void apply(TomlNode& tree, const std::string& text, const SourceLocation& location) {
  PathReader reader(text);
  const std::vector<PathStep> steps = reader.read();
  TomlNode value = parsed_value(reader.value());
  place(value, location);
  TomlNode* node = &tree;
  for (const PathStep& step : steps)
    node = step.index ? &item_of(*node, *step.index) : &member_of(*node, step.key, location);
  *node = std::move(value);
}

}  // namespace

void apply_overrides(TomlNode& tree, const std::vector<std::string>& overrides, ProblemList& problems) {
  for (const std::string& text : overrides) {
    const SourceLocation location{"--set " + text, 0, 0};
    try {
      apply(tree, text, location);
    } catch (const Error& error) {
      problems.add(location, error.what());
    }
  }
}

std::string overridden_key(const std::string& text) { return text.substr(0, text.find('=')); }

}  // namespace lacuna
