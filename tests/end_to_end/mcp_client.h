#pragma once

#include "end_to_end/program.h"
#include "process/child_lines.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// `lacuna mcp` at work in a program's folder, and the client that speaks with it.
class McpClient {
 public:
  explicit McpClient(const Program& program, const std::map<std::string, std::string>& environment = {},
                     const std::vector<std::string>& options = {});

  /// A line as it is.
  void send(const std::string& line);
  void notify(const std::string& method, const nlohmann::json& params);
  /// The next message; throws where the server ends, or says nothing for minutes.
  nlohmann::json receive();
  /// Sends a request; its number.
  int ask(const std::string& method, const nlohmann::json& params);
  /// The answer to it; what comes before is put into `others`.
  nlohmann::json answer_to(int id);
  /// The answer's "result" or, of one that fails, "error".
  nlohmann::json request(const std::string& method, const nlohmann::json& params);
  void initialize(const std::string& version = "2025-11-25");
  /// The result of a call of a tool.
  nlohmann::json call(const std::string& tool, const nlohmann::json& arguments);

  std::vector<nlohmann::json> others;

 private:
  ChildLines server_;
  int requests_ = 0;
};

}  // namespace lacuna
