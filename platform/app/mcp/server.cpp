#include "app/mcp/server.h"

#include "app/mcp/tool_words.h"
#include "foundation/text/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

constexpr const char* kVersions[] = {"2025-11-25", "2025-06-18", "2024-11-05"};  // the first is the newest
constexpr std::size_t kMostWaiting = 32;                                         // calls

constexpr const char* kInstructions =
    "Lacuna finds the physical effect that a robot model is missing. The order of work: new (from recordings), check, "
    "compare, diagnose, add (answer = true), compare again, until diagnose says nothing_missing. Each answer has a "
    "conclusion and the next calls; a diagnosis also has a verdict with its probability and the test to record next. "
    "Conclude no more than that. File names are relative to the folder in which the server was started.";

std::string text_or_empty(const ordered_json& object, const char* name) {
  return object.contains(name) && object[name].is_string() ? object[name].get<std::string>() : std::string();
}

ordered_json member_object(const RpcMessage& request, const char* name) {
  if (!request.params.contains(name)) return ordered_json::object();
  if (request.params[name].is_object()) return request.params[name];
  throw RpcError(RpcCode::invalid_params, fmt::format("\"{}\" must be an object", name), *request.id);
}

std::optional<ordered_json> progress_token(const RpcMessage& request) {
  const ordered_json meta = member_object(request, "_meta");
  if (!meta.contains("progressToken")) return std::nullopt;
  if (meta["progressToken"].is_string() || meta["progressToken"].is_number_integer()) return meta["progressToken"];
  throw RpcError(RpcCode::invalid_params, "\"progressToken\" must be a text or a whole number", *request.id);
}

/// An export of rows writes them where its arguments say; json is one of their formats.
bool exports_rows(const Tool& tool, const ordered_json& arguments) {
  return tool.name == "export" && !arguments.contains("urdf") && !arguments.contains("mjcf") &&
         !arguments.contains("toml");
}

}  // namespace

McpServer::McpServer(std::vector<Tool> tools, CallPlace place, std::function<void(const std::string&)> write)
    : tools_(std::move(tools)), place_(std::move(place)), allowed_({place_.folder}), write_(std::move(write)) {}

void McpServer::take(const std::string& line) {
  if (line.find_first_not_of(" \t\r") == std::string::npos) return;
  try {
    const RpcMessage message = read_rpc_message(line);
    if (message.method.empty()) return;  // an answer, and nothing was asked
    if (message.id)
      answer(message);
    else
      note(message);
  } catch (const RpcError& error) {
    write_(rpc_error(error));
  }
}

void McpServer::refuse_long_line(std::size_t longest) {
  write_(rpc_error(RpcError(RpcCode::parse_error, fmt::format("the line is longer than {} bytes", longest))));
}

void McpServer::answer(const RpcMessage& request) {
  if (request.method == "ping") return write_(rpc_result(*request.id, ordered_json::object()));
  if (request.method == "initialize") return write_(rpc_result(*request.id, initialize(request)));
  if (request.method != "tools/list" && request.method != "tools/call")
    throw RpcError(RpcCode::unknown_method, fmt::format("there is no method \"{}\"", request.method), *request.id);
  if (!initialized_) throw RpcError(RpcCode::invalid_request, "send \"initialize\" first", *request.id);
  if (request.method == "tools/list") return write_(rpc_result(*request.id, list()));
  call(request);
}

void McpServer::note(const RpcMessage& notification) {
  if (notification.method == "notifications/cancelled" && notification.params.contains("requestId"))
    cancel(notification.params["requestId"]);
}

ordered_json McpServer::initialize(const RpcMessage& request) {
  const std::string wanted = text_or_empty(request.params, "protocolVersion");
  if (wanted.empty())
    throw RpcError(RpcCode::invalid_params, "\"protocolVersion\" is missing, the revision that the client speaks",
                   *request.id);
  const bool known = std::find(std::begin(kVersions), std::end(kVersions), wanted) != std::end(kVersions);
  version_ = known ? wanted : kVersions[0];
  initialized_ = true;
  return {{"protocolVersion", version_},
          {"capabilities", {{"tools", {{"listChanged", false}}}}},
          {"serverInfo", {{"name", "lacuna"}, {"title", "Lacuna"}, {"version", LACUNA_VERSION}}},
          {"instructions", kInstructions}};
}

ordered_json McpServer::list() const {
  ordered_json tools = ordered_json::array();
  for (const Tool& tool : tools_) tools.push_back(tool_json(tool));
  return {{"tools", tools}};
}

const Tool& McpServer::find_tool(const RpcMessage& request) const {
  const std::string name = text_or_empty(request.params, "name");
  std::vector<std::string> names;
  for (const Tool& tool : tools_) {
    if (tool.name == name) return tool;
    names.push_back(tool.name);
  }
  throw RpcError(RpcCode::invalid_params, fmt::format("there is no tool \"{}\"{}", name, did_you_mean(name, names)),
                 *request.id);
}

void McpServer::check_new(const ordered_json& id) const {
  const auto has_id = [&](const Call& one) { return one.id == id; };
  if ((running_ && current_.id == id) || std::any_of(waiting_.begin(), waiting_.end(), has_id))
    throw RpcError(RpcCode::invalid_request,
                   "a call with this \"id\" is still running; give each request a different \"id\"", id);
}

/// From its revision of 2025-11-25 on the protocol has what an agent can mend told as the tool's answer.
ordered_json McpServer::answer_to_faulty(const Call& call, const std::string& faults) const {
  if (version_ != kVersions[0]) throw RpcError(RpcCode::invalid_params, faults, call.id);
  CallOutcome outcome{2, nullptr, "", {}};
  std::istringstream lines(faults);
  for (std::string line; std::getline(lines, line);) outcome.notes.push_back(line);
  return call_answer(*call.tool, call.arguments, outcome);
}

void McpServer::call(const RpcMessage& request) {
  check_new(*request.id);
  Call call{*request.id, &find_tool(request), member_object(request, "arguments"), progress_token(request), {}, {}};
  if (waiting_.size() >= kMostWaiting)
    throw RpcError(RpcCode::invalid_request,
                   fmt::format("{} calls are waiting already; wait for their answers", waiting_.size()), call.id);
  try {
    call.words = words_of_call(*call.tool, call.arguments, allowed_);
  } catch (const BadInput& faults) {
    return write_(rpc_result(call.id, answer_to_faulty(call, faults.what())));
  }
  const std::string own = text_or_empty(call.arguments, "json");
  if (!own.empty())
    call.results = place_.folder / own;
  else if (call.tool->has_json && !exports_rows(*call.tool, call.arguments))
    call.results = place_.scratch / fmt::format("result-{}.json", ++calls_);
  waiting_.push_back(std::move(call));
  look();
}

void McpServer::cancel(const ordered_json& id) {
  if (running_ && current_.id == id) {
    cancelled_ = true;
    return running_->cancel();
  }
  std::erase_if(waiting_, [&](const Call& one) { return one.id == id; });
}

void McpServer::begin_next() {
  current_ = std::move(waiting_.front());
  waiting_.pop_front();
  cancelled_ = false;
  told_.clear();
  try {
    running_ = std::make_unique<ToolCall>(place_, current_.words, current_.results);
  } catch (const Error& error) {
    write_(rpc_result(current_.id, call_answer(*current_.tool, current_.arguments, {1, nullptr, "", {error.what()}})));
  }
}

void McpServer::tell_progress() {
  const std::string line = running_->progress();
  if (!current_.progress_token || cancelled_ || line.empty() || line == told_) return;
  told_ = line;
  write_(rpc_notification(
      "notifications/progress",
      {{"progressToken", *current_.progress_token}, {"progress", running_->seconds()}, {"message", line}}));
}

void McpServer::look() {
  if (!running_ && !waiting_.empty()) begin_next();
  if (!running_) return;
  tell_progress();
  const std::optional<CallOutcome> outcome = running_->look();
  if (!outcome) return;
  if (!cancelled_) write_(rpc_result(current_.id, call_answer(*current_.tool, current_.arguments, *outcome)));
  running_.reset();
}

}  // namespace lacuna
