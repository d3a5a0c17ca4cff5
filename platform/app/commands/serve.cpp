#include "app/commands/commands.h"
#include "app/runs/replays.h"
#include "app/terminal/options.h"
#include "app/terminal/scratch_folder.h"
#include "command_line/whole_number.h"
#include "foundation/processes/interrupt.h"
#include "foundation/processes/processes.h"
#include "report/pages/page_server.h"
#include "report/pages/pages.h"
#include "storage/files/log_left.h"
#include "storage/results/stored_run.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <thread>

namespace lacuna {
namespace {

struct ServeOptions {
  std::filesystem::path database;
  std::string host = "127.0.0.1";
  int port = 0;
  bool open = false;
  std::vector<std::filesystem::path> plugin_paths;
};

constexpr auto kLook = std::chrono::milliseconds(100);

bool is_loopback(const std::string& host) { return host == "127.0.0.1" || host == "localhost" || host == "::1"; }

/// Everybody can see what programs are called with, so that a token is handed over in a file of our own.
std::string page_to_open(const std::string& address, const ScratchFolder& scratch) {
  const std::filesystem::path page = scratch / "open.html";
  std::ofstream(page) << fmt::format("<!doctype html><meta http-equiv=\"refresh\" content=\"0; url={}\">\n", address);
  return page.string();
}

void open_browser(const std::string& page) {
  const pid_t child = fork();
  if (child == 0) {
    if (fork() == 0) execlp("env", "env", kOutlives, "xdg-open", page.c_str(), static_cast<char*>(nullptr));
    _exit(0);
  }
  if (child > 0) waitpid(child, nullptr, 0);
}

/// A command that has just begun may make it. False: the user does not want to wait.
bool wait_for(const std::filesystem::path& database) {
  const std::filesystem::path folder = database.has_parent_path() ? database.parent_path() : ".";
  const auto is_missing = [&] {
    std::error_code missing;
    return std::filesystem::file_size(database, missing) == 0 || missing == std::errc::no_such_file_or_directory;
  };
  if (!is_missing() || !std::filesystem::exists(folder)) return true;
  fmt::print(stderr, "waiting until `lacuna compare` or `lacuna run` makes {}; stop with Ctrl-C\n", database.string());
  const Stop stop = when_interrupted();
  while (is_missing() && !stop.is_due()) std::this_thread::sleep_for(kLook);
  return !stop.is_due();
}

void serve(const ServeOptions& options) {
  require_pages();
  if (!wait_for(options.database)) return;
  const LogLeft log(options.database);
  const Stop stop = when_interrupted();
  check_stored_texts(Database::open_read_only(options.database, stop));  // says what is wrong before anything else
  const ScratchFolder scratch;
  PageDatabase pages(scratch / "pages.db");
  pages.add_about("database", options.database.filename().string());
  pages.add_about("lacuna", LACUNA_VERSION);
  Replays replays(options.database, options.plugin_paths, pages, stop);
  PageServer server(
      {.database = options.database,
       .pages = scratch / "pages.db",
       .host = options.host,
       .port = options.port,
       .prepare_replay = [&](std::int64_t run, std::int64_t trial) { return replays.prepare(run, trial); },
       .stop = stop});
  if (!is_loopback(options.host))
    std::fprintf(stderr,
                 "warning: anybody who can reach %s and knows this address with its token can read the whole database; "
                 "the connection is not encrypted\n",
                 options.host.c_str());
  fmt::print("{}\n", server.address());
  std::fflush(stdout);
  fmt::print(stderr, "serving {} read-only; stop with Ctrl-C\n", options.database.string());
  if (options.open) open_browser(page_to_open(server.address(), scratch));
  std::atomic<bool> ended = false;
  std::thread answering([&] {
    server.run();
    ended = true;
  });
  while (!stop.is_due() && !ended) std::this_thread::sleep_for(kLook);
  server.stop();
  answering.join();
}

}  // namespace

void add_serve_command(CLI::App& program) {
  auto options = std::make_shared<ServeOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("serve", "Show a database as live pages in a browser on this machine");
  add_database_argument(*command, options->database);
  command->add_option("--port", options->port, "Port (default: a free one)")
      ->option_text("N")
      ->check(whole_number(0, 65535));
  command->add_option("--host", options->host, "Address to listen on (default: 127.0.0.1, this machine only)")
      ->option_text("ADDRESS");
  command->add_flag("--open", options->open, "Open a browser");
  command->add_option("--plugin-path", options->plugin_paths, "Folder with plugins, searched before all others")
      ->allow_extra_args(false)
      ->option_text("FOLDER");
  command->callback([options] { serve(*options); });
}

}  // namespace lacuna
