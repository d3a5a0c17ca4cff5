#include "app/mcp/rpc_message.h"

#include "foundation/text/json_depth.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

ordered_json parsed_line(const std::string& line) {
  if (nests_too_deep(line))
    throw RpcError(RpcCode::parse_error,
                   fmt::format("the message nests arrays and objects more than {} levels deep", kDeepestJson));
  try {
    return ordered_json::parse(line);
  } catch (const ordered_json::exception& error) {
    const std::string what = error.what();  // "[json.exception.parse_error.101] parse error at line 1, column 3: ..."
    throw RpcError(RpcCode::parse_error,
                   "the line is not JSON: " + what.substr(what.find("] ") + 2) + "; send one JSON object per line");
  }
}

bool is_id(const ordered_json& id) { return id.is_string() || id.is_number_integer(); }

std::optional<ordered_json> id_of(const ordered_json& message) {
  if (!message.contains("id")) return std::nullopt;
  if (is_id(message["id"])) return message["id"];
  throw RpcError(RpcCode::invalid_request, "\"id\" must be a text or a whole number");
}

/// Unread messages are written with U+FFFD where a plugin's text is not UTF-8.
std::string dumped(const ordered_json& message) {
  return message.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

RpcMessage read_rpc_message(const std::string& line) {
  const ordered_json json = parsed_line(line);
  if (json.is_array())
    throw RpcError(RpcCode::invalid_request, "batches of messages are not supported; send one JSON object per line");
  if (!json.is_object()) throw RpcError(RpcCode::invalid_request, "the message is not a JSON object");
  const std::optional<ordered_json> id = id_of(json);
  const ordered_json id_or_null = id.value_or(nullptr);
  if (!json.contains("jsonrpc") || json["jsonrpc"] != "2.0")
    throw RpcError(RpcCode::invalid_request, "\"jsonrpc\" must be \"2.0\"", id_or_null);
  if (!json.contains("method") && (json.contains("result") || json.contains("error"))) return {id, "", {}};
  if (!json.contains("method") || !json["method"].is_string() || json["method"] == "")
    throw RpcError(RpcCode::invalid_request, "\"method\" must be the name of a method", id_or_null);
  RpcMessage message{id, json["method"], ordered_json::object()};
  if (!json.contains("params")) return message;
  if (!json["params"].is_object()) throw RpcError(RpcCode::invalid_params, "\"params\" must be an object", id_or_null);
  message.params = json["params"];
  return message;
}

std::string rpc_result(const ordered_json& id, const ordered_json& result) {
  return dumped({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}});
}

std::string rpc_error(const RpcError& error) {
  return dumped({{"jsonrpc", "2.0"},
                 {"id", error.id()},
                 {"error", {{"code", static_cast<int>(error.code())}, {"message", error.what()}}}});
}

std::string rpc_notification(const std::string& method, const ordered_json& params) {
  return dumped({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
}

}  // namespace lacuna
