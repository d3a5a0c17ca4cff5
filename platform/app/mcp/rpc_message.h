#pragma once

#include <lacuna/error.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace lacuna {

/// Codes of JSON-RPC 2.0.
enum class RpcCode {
  parse_error = -32700,
  invalid_request = -32600,
  unknown_method = -32601,
  invalid_params = -32602,
};

/// Thrown where a request is answered by an error of the protocol. `id`: the request's, null where it is not known.
class RpcError : public Error {
 public:
  RpcError(RpcCode code, const std::string& message, nlohmann::ordered_json id = nullptr)
      : Error(message), code_(code), id_(std::move(id)) {}
  RpcCode code() const { return code_; }
  const nlohmann::ordered_json& id() const { return id_; }

 private:
  RpcCode code_;
  nlohmann::ordered_json id_;
};

/// A request or a notification of JSON-RPC 2.0, or the answer to a request, of which this program makes none.
struct RpcMessage {
  std::optional<nlohmann::ordered_json> id;  ///< a text or a whole number; of a notification none
  std::string method;                        ///< of an answer empty
  nlohmann::ordered_json params;             ///< an object, empty where there was none
};

/// Reads a line. Throws `RpcError` where it is not JSON or not a message of JSON-RPC 2.0.
RpcMessage read_rpc_message(const std::string& line);

/// Lines without their newline.
std::string rpc_result(const nlohmann::ordered_json& id, const nlohmann::ordered_json& result);
std::string rpc_error(const RpcError& error);
std::string rpc_notification(const std::string& method, const nlohmann::ordered_json& params);

}  // namespace lacuna
