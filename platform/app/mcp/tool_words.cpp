#include "app/mcp/tool_words.h"

#include "foundation/text/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

const char* kind_of(OptionValue value) {
  switch (value) {
    case OptionValue::none: return "true or false";
    case OptionValue::whole_number: return "a whole number";
    case OptionValue::number: return "a number";
    default: return "a text";
  }
}

bool is_name_of_file(OptionValue value) {
  return value == OptionValue::file || value == OptionValue::folder || value == OptionValue::optional_file;
}

/// A value as the command line takes it; nothing where its type is another one.
std::optional<std::string> word_of(const ordered_json& value, OptionValue kind) {
  if (kind == OptionValue::whole_number || kind == OptionValue::number) {
    const bool fits = kind == OptionValue::number ? value.is_number() : value.is_number_integer();
    return fits ? std::optional(value.dump()) : std::nullopt;
  }
  return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
}

class CallWords {
 public:
  CallWords(const Tool& tool, const AllowedFiles& allowed) : words_(tool.words), allowed_(allowed) {}

  void take(const OptionFacts& option, const ordered_json& value) {
    name_ = argument_name(option);
    if (option.value == OptionValue::none) return take_flag(option, value);
    if (!option.repeats) return take_value(option, value);
    if (!value.is_array()) return fault("must be an array");
    for (const ordered_json& one : value) take_value(option, one);
  }

  void missing(const std::string& name) {
    name_ = name;
    fault("is missing");
  }
  void unknown(const std::string& name, const std::vector<std::string>& known) {
    name_ = name;
    fault("is no argument of this tool" + did_you_mean(name, known));
  }

  std::vector<std::string> finished() {
    faults_.throw_if_any();
    if (!arguments_.empty()) words_.emplace_back("--");
    words_.insert(words_.end(), arguments_.begin(), arguments_.end());
    return words_;
  }

 private:
  void take_flag(const OptionFacts& option, const ordered_json& value) {
    if (!value.is_boolean()) return fault("must be true or false");
    if (value.get<bool>()) words_.push_back("--" + option.name);
  }

  void take_value(const OptionFacts& option, const ordered_json& value) {
    const std::optional<std::string> word = word_of(value, option.value);
    if (!word)
      return fault(fmt::format("must be {}{}", option.repeats ? "an array, each element " : "", kind_of(option.value)));
    if (word->find('\0') != std::string::npos) return fault("holds a zero byte");
    if (word->empty()) return fault("is empty");
    if (is_name_of_file(option.value))
      if (const std::string why = allowed_.why_not_read(*word); !why.empty()) return fault(*word + " " + why);
    if (option.positional)
      arguments_.push_back(*word);
    else
      words_.push_back(fmt::format("--{}={}", option.name, *word));
  }

  void fault(const std::string& message) { faults_.add({}, name_ + ": " + message); }

  std::vector<std::string> words_, arguments_;
  const AllowedFiles& allowed_;
  std::string name_;  ///< of the argument that is looked at
  ProblemList faults_;
};

}  // namespace

std::vector<std::string> words_of_call(const Tool& tool, const ordered_json& arguments, const AllowedFiles& allowed) {
  CallWords words(tool, allowed);
  std::vector<std::string> names;
  for (const OptionFacts& option : tool.options) {
    const std::string name = names.emplace_back(argument_name(option));
    if (arguments.contains(name))
      words.take(option, arguments[name]);
    else if (option.required)
      words.missing(name);
  }
  for (const auto& [name, value] : arguments.items())
    if (std::find(names.begin(), names.end(), name) == names.end()) words.unknown(name, names);
  return words.finished();
}

}  // namespace lacuna
