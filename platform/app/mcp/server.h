#pragma once

#include "app/mcp/rpc_message.h"
#include "app/mcp/tool_call.h"
#include "foundation/files/allowed_files.h"

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A server of the Model Context Protocol (revisions 2025-11-25, 2025-06-18 and 2024-11-05) whose tools are commands of
/// this program. It is given messages as they come and writes its own; calls of tools are carried out one after the
/// other while it answers everything else. One thread.
class McpServer {
 public:
  /// `write`: is given each message, a line without its newline.
  McpServer(std::vector<Tool> tools, CallPlace place, std::function<void(const std::string&)> write);

  /// A line of the client. A wrong line gets an error as answer; nothing is thrown.
  void take(const std::string& line);
  /// Answers that a line was longer than `longest` bytes.
  void refuse_long_line(std::size_t longest);
  /// Moves the calls on: to be called every few hundredths of a second while `is_busy`.
  void look();
  bool is_busy() const { return running_ != nullptr || !waiting_.empty(); }

 private:
  struct Call {
    nlohmann::ordered_json id;
    const Tool* tool = nullptr;
    nlohmann::ordered_json arguments;
    std::optional<nlohmann::ordered_json> progress_token;
    std::vector<std::string> words;
    std::filesystem::path results;
  };

  void answer(const RpcMessage& request);
  void note(const RpcMessage& notification);
  nlohmann::ordered_json initialize(const RpcMessage& request);
  nlohmann::ordered_json list() const;
  void call(const RpcMessage& request);
  void cancel(const nlohmann::ordered_json& id);
  void begin_next();
  void tell_progress();
  void check_new(const nlohmann::ordered_json& id) const;
  const Tool& find_tool(const RpcMessage& request) const;
  nlohmann::ordered_json answer_to_faulty(const Call& call, const std::string& faults) const;

  std::vector<Tool> tools_;
  CallPlace place_;
  AllowedFiles allowed_;
  std::function<void(const std::string&)> write_;
  bool initialized_ = false;
  std::string version_;
  std::deque<Call> waiting_;
  Call current_;  ///< what `running_` carries out
  std::unique_ptr<ToolCall> running_;
  bool cancelled_ = false;  ///< the current one, which gets no answer
  std::string told_;        ///< the last progress that was told
  int calls_ = 0;
};

}  // namespace lacuna
