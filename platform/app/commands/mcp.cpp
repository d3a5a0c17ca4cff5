#include "app/commands/commands.h"
#include "app/mcp/message_lines.h"
#include "app/mcp/server.h"
#include "app/terminal/plain_streams.h"
#include "app/terminal/scratch_folder.h"
#include "app/terminal/time_limit.h"
#include "foundation/files/file_sandbox.h"
#include "foundation/processes/interrupt.h"

#include <CLI/CLI.hpp>

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

namespace lacuna {
namespace {

constexpr std::size_t kLongestMessage = std::size_t{4} << 20U;  // bytes
constexpr int kBusyWait = 20, kIdleWait = 200;                  // ms, between looks at calls and at interrupts
constexpr const char* kNoSandbox =
    "lacuna mcp: this kernel has no Landlock, so plugins in the folder can read and write other files; use only "
    "plugins that you trust";

struct McpOptions {
  double call_limit = 3600.0;  // s
};

void write_message(const std::string& message) {
  exact_output() << message << '\n' << std::flush;
  if (!exact_output().good()) throw Error("standard output: the client has stopped reading");
}

/// Whether somebody may still read answers; a client that is gone has closed its end of the pipe.
bool has_reader() {
  pollfd output{STDOUT_FILENO, 0, 0};
  return ::poll(&output, 1, 0) <= 0 || (output.revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
}

/// Calls that were sent before the client closed the standard input are answered while it reads.
void finish_calls(McpServer& server, const Stop& stop) {
  while (server.is_busy() && has_reader() && !stop.is_due()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(kBusyWait));
    server.look();
  }
}

/// Until the client closes the standard input, or `stop` is due.
void serve_client(McpServer& server, const Stop& stop) {
  MessageLines lines(STDIN_FILENO, kLongestMessage);
  std::string line;
  while (!stop.is_due()) {
    switch (lines.next(line, server.is_busy() ? kBusyWait : kIdleWait)) {
      case MessageLines::Got::line: server.take(line); break;
      case MessageLines::Got::too_long: server.refuse_long_line(kLongestMessage); break;
      case MessageLines::Got::end: return finish_calls(server, stop);
      case MessageLines::Got::nothing: break;
    }
    server.look();
  }
}

void run_mcp(const McpOptions& options, const CLI::App& program) {
  if (!has_file_sandbox()) std::fprintf(stderr, "%s\n", kNoSandbox);
  const ScratchFolder scratch;
  const std::filesystem::path folder = std::filesystem::canonical(std::filesystem::current_path());
  McpServer server(tools_of(option_tree(program)),
                   {folder, std::filesystem::canonical(scratch.path()), options.call_limit}, write_message);
  serve_client(server, when_interrupted());
}

}  // namespace

void add_mcp_command(CLI::App& program) {
  auto options = std::make_shared<McpOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("mcp", "Serve the commands to an AI agent over the Model Context Protocol");
  command
      ->add_option_function<std::string>(
          "--call-limit",
          [options](const std::string& text) { options->call_limit = parse_duration("--call-limit", text); },
          "Time limit of one command that the agent calls: 600, \"1 h\" (default: 1 h)")
      ->option_text("DURATION");
  command->callback([&program, options] { run_mcp(*options, program); });
}

}  // namespace lacuna
