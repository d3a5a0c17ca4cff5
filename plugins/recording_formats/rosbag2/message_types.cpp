#include "message_types.h"

#include "bad_bag.h"
#include "builtin_types.h"
#include "definition_lines.h"

#include <map>
#include <utility>

namespace lacuna::rosbag2 {
namespace {

constexpr std::size_t kMostTypes = 512;
constexpr std::size_t kDeepest = 24;

std::string package_of(const std::string& name) { return name.substr(0, name.find('/')); }

/// Collects the types of a message, each once.
class TypeBuilder {
 public:
  TypeBuilder(const std::string& root, std::map<std::string, std::string_view> definitions)
      : definitions_(std::move(definitions)) {
    add(root, 0);
  }
  MessageTypes take() { return std::move(made_); }

 private:
  std::size_t add(const std::string& name, std::size_t depth) {
    if (depth == kDeepest) throw BadBag("the type " + name + " contains itself, or is nested too deeply");
    const auto known = indices_.find(name);
    if (known != indices_.end()) return known->second;
    if (made_.types.size() == kMostTypes) throw BadBag("a type is made of more than 512 others");
    const std::size_t index = made_.types.size();
    made_.types.push_back({name, {}});
    std::vector<MessageField> fields;
    for (const DefinitionLine& line : lines_of_definition(definition_of(name))) {
      MessageField field = line.field;
      if (field.primitive == Primitive::none) field.type = add(whole_name(line.type, name), depth + 1);
      fields.push_back(std::move(field));
    }
    made_.types[index].fields = std::move(fields);
    indices_.emplace(name, index);  // only now: a type that contains itself exceeds the depth
    return index;
  }

  std::string_view definition_of(const std::string& name) const {
    const auto found = definitions_.find(name);
    if (found != definitions_.end()) return found->second;
    if (const auto builtin = builtin_definitions(name); !builtin.empty()) return builtin.back();
    throw BadBag("the definition of " + name + " is not in the bag");
  }

  /// A name without a package belongs to the package of the enclosing type.
  std::string whole_name(const std::string& type, const std::string& user) const {
    if (type.find('/') != type.npos) return plain_type_name(type);
    if (type == "Header") return "std_msgs/Header";
    return package_of(user) + "/" + type;
  }

  std::map<std::string, std::string_view> definitions_;
  std::map<std::string, std::size_t> indices_;
  MessageTypes made_;
};

}  // namespace

std::size_t size_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::boolean:
    case Primitive::int8:
    case Primitive::uint8: return 1;
    case Primitive::int16:
    case Primitive::uint16: return 2;
    case Primitive::int64:
    case Primitive::uint64:
    case Primitive::float64: return 8;
    default: return 4;
  }
}

std::string plain_type_name(std::string_view name) {
  const std::size_t end = name.find('/'), last = name.rfind('/');
  if (end == name.npos || end == last) return std::string(name);
  return std::string(name.substr(0, end)) + std::string(name.substr(last));
}

MessageTypes parse_definition(const std::string& root, std::string_view text) {
  return TypeBuilder(plain_type_name(root), split_definitions(plain_type_name(root), text)).take();
}

std::vector<MessageTypes> known_types(const std::string& root) {
  const std::string name = plain_type_name(root);
  std::vector<MessageTypes> known;
  for (const std::string_view definition : builtin_definitions(name))
    known.push_back(TypeBuilder(name, {{name, definition}}).take());
  if (known.empty()) throw BadBag("the definition of " + root + " is not in the bag");
  return known;
}

}  // namespace lacuna::rosbag2
