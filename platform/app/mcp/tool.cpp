#include "app/mcp/tool.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

/// What the option tree does not say of a command.
struct AgentsCommand {
  std::vector<std::string> words;
  bool reads_only;
  std::vector<std::string> required;  ///< besides what the command line requires
  std::string_view advice;
};

/// Of every command: results come back as JSON anyway.
constexpr std::string_view kLeftOut[] = {"help", "quiet", "csv", "print-reference", "verbose"};

const std::vector<AgentsCommand>& agents_commands() {
  static const std::vector<AgentsCommand> commands = {
      {{"new"},
       false,
       {},
       "Begin here when there are recordings and no experiment file. The answer lists the lines to fill in."},
      {{"check"},
       true,
       {"experiment"},
       "Call it before any other command on an experiment, and after each edit of the file."},
      {{"fit"}, false, {}, "compare does this too."},
      {{"compare"},
       false,
       {},
       "Gives the error in multiples of the noise floor, and where it is large. Each call counts as a look at the "
       "held-out files."},
      {{"diagnose"},
       false,
       {},
       "Gives a verdict (effect_found, nothing_missing, not_in_library, cannot_tell), its probability where one is "
       "stated, and the test to record next. Takes minutes."},
      {{"add"},
       false,
       {},
       "With answer = true it adds the effects that the last diagnosis found. Edits the experiment file."},
      {{"undo"}, false, {}, "Edits the experiment file."},
      {{"history"}, true, {}, "Cheap: it fits nothing and reads no held-out file."},
      {{"predict"}, false, {}, "Predicts the outcome of a test before it is carried out."},
      {{"trial"},
       false,
       {},
       "For a recorded target give csv, a file for the commands of the next test on the rig. An agent may not start a "
       "target that is a program."},
      {{"export"},
       false,
       {},
       "From an experiment, the identified robot: give urdf, mjcf or toml. From a database, rows: give what, and a "
       "file as csv, json, npz or mcap."},
      {{"report"}, false, {"out"}, "For people: the page shows all results of the database."},
      {{"sql"},
       true,
       {},
       "With views = true it lists the views, each with an example; then give database and sql. Give LIMIT: answers "
       "longer than 256 kB are cut."},
      {{"plugins", "list"}, true, {}, "kind = \"effect\" lists the effects that a model may include."},
      {{"plugins", "show"},
       true,
       {},
       "Gives an effect's equation, its parameters, where it can be placed, and which effects are hard to tell from "
       "it."},
  };
  return commands;
}

bool is_left_out(const AgentsCommand& command, const OptionFacts& option) {
  if (option.name == "csv" && command.words.front() == "trial") return false;              // the commands for a rig
  if (option.name == "csv" && command.words.front() == "export") return false;             // a format of its rows
  if (command.reads_only && (option.name == "json" || option.name == "out")) return true;  // it writes no file either
  return std::find(std::begin(kLeftOut), std::end(kLeftOut), option.name) != std::end(kLeftOut);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Tool tool_of(const AgentsCommand& command, const CommandFacts& facts) {
  Tool tool{fmt::format("{}", fmt::join(command.words, "_")),
            fmt::format("lacuna {}", fmt::join(command.words, " ")),
            fmt::format("{}. {}", facts.description, command.advice),
            command.words,
            {},
            command.reads_only};
  for (OptionFacts option : facts.options) {
    tool.has_json = tool.has_json || option.name == "json";
    option.required = option.required || contains(command.required, option.name);
    if (!is_left_out(command, option)) tool.options.push_back(std::move(option));
  }
  return tool;
}

const char* json_type(OptionValue value) {
  switch (value) {
    case OptionValue::none: return "boolean";
    case OptionValue::whole_number: return "integer";
    case OptionValue::number: return "number";
    default: return "string";
  }
}

ordered_json schema_of(const OptionFacts& option) {
  const std::string description = option.name == "json"
                                      ? "File for the complete results; the answer leaves out long lists of numbers"
                                      : option.description;
  if (!option.repeats) return {{"type", json_type(option.value)}, {"description", description}};
  return {{"type", "array"},
          {"items", {{"type", json_type(option.value)}}},
          {"minItems", option.required ? 1 : 0},
          {"description", description}};
}

ordered_json input_schema(const Tool& tool) {
  ordered_json properties = ordered_json::object(), required = ordered_json::array();
  for (const OptionFacts& option : tool.options) {
    properties[argument_name(option)] = schema_of(option);
    if (option.required) required.push_back(argument_name(option));
  }
  return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

/// Of every tool; what a command finds stands under "result", as its --json has it.
ordered_json output_schema() {
  return {
      {"type", "object"},
      {"properties",
       {{"exit_code",
         {{"type", "integer"}, {"description", "0 done, 1 failed, 2 bad input, 75 stopped: call again to continue"}}},
        {"conclusion", {{"type", "string"}, {"description", "The conclusion that the result supports"}}},
        {"verdict", {{"type", "string"}}},
        {"probability",
         {{"type", {"number", "null"}}, {"description", "Probability that the verdict is right; null: not stated"}}},
        {"record_next", {{"type", {"object", "null"}}, {"description", "The most informative next test"}}},
        {"next",
         {{"type", "array"}, {"items", {{"type", "object"}}}, {"description", "Tools to call next, with arguments"}}},
        {"notes", {{"type", "array"}, {"items", {{"type", "string"}}}}},
        {"result", {{"description", "What the command writes with --json; long lists of numbers left out"}}}}},
      {"required", {"exit_code", "conclusion"}}};
}

}  // namespace

std::string argument_name(const OptionFacts& option) {
  std::string name = option.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<Tool> tools_of(const std::vector<CommandFacts>& tree) {
  std::vector<Tool> tools;
  for (const AgentsCommand& command : agents_commands())
    for (const CommandFacts& facts : tree)
      if (facts.words == command.words) tools.push_back(tool_of(command, facts));
  return tools;
}

ordered_json tool_json(const Tool& tool) {
  return {{"name", tool.name},
          {"title", tool.title},
          {"description", tool.description},
          {"inputSchema", input_schema(tool)},
          {"outputSchema", output_schema()},
          {"annotations",
           {{"title", tool.title},
            {"readOnlyHint", tool.reads_only},
            {"destructiveHint", false},
            {"idempotentHint", tool.reads_only},
            {"openWorldHint", false}}}};
}

}  // namespace lacuna
