#include "end_to_end/mcp_client.h"

namespace lacuna {
namespace {

constexpr double kPatience = 300.0;  // s

ProcessSource server_of(const Program& program, const std::map<std::string, std::string>& environment,
                        const std::vector<std::string>& options) {
  ProcessSource source;
  source.command = {LACUNA_BINARY_DIRECTORY "/bin/lacuna", "mcp"};
  source.command.insert(source.command.end(), options.begin(), options.end());
  source.folder = program.folder();
  source.environment = environment;
  return source;
}

}  // namespace

McpClient::McpClient(const Program& program, const std::map<std::string, std::string>& environment,
                     const std::vector<std::string>& options)
    : server_(server_of(program, environment, options), Stop()) {}

void McpClient::send(const std::string& line) { server_.send(line, ChildLines::in(kPatience)); }

void McpClient::notify(const std::string& method, const nlohmann::json& params) {
  send(nlohmann::json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
}

nlohmann::json McpClient::receive() { return nlohmann::json::parse(server_.receive(ChildLines::in(kPatience))); }

int McpClient::ask(const std::string& method, const nlohmann::json& params) {
  send(nlohmann::json{{"jsonrpc", "2.0"}, {"id", ++requests_}, {"method", method}, {"params", params}}.dump());
  return requests_;
}

nlohmann::json McpClient::answer_to(int id) {
  for (;;) {
    nlohmann::json message = receive();
    if (message.value("id", nlohmann::json()) == id) return message;
    others.push_back(std::move(message));
  }
}

nlohmann::json McpClient::request(const std::string& method, const nlohmann::json& params) {
  const nlohmann::json answer = answer_to(ask(method, params));
  return answer.contains("result") ? answer["result"] : answer["error"];
}

void McpClient::initialize(const std::string& version) {
  request("initialize", {{"protocolVersion", version},
                         {"capabilities", nlohmann::json::object()},
                         {"clientInfo", {{"name", "test"}, {"version", "1"}}}});
  notify("notifications/initialized", nlohmann::json::object());
}

nlohmann::json McpClient::call(const std::string& tool, const nlohmann::json& arguments) {
  return request("tools/call", {{"name", tool}, {"arguments", arguments}});
}

}  // namespace lacuna
