#include "app/commands/commands.h"

#include "app/terminal/json_messages.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/plain_streams.h"
#include "app/terminal/time_limit.h"
#include "command_line/subcommands.h"
#include "command_line/usage_error.h"
#include "foundation/processes/end_without_memory.h"
#include "foundation/files/file_sandbox.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/plain_text.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/text/problem.h"
#include "foundation/processes/process_limits.h"
#include "kernels/kernels.h"
#include "loading/plugin_library.h"

#include <CLI/CLI.hpp>

#include <execinfo.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr int kFailed = 1;
constexpr int kBadInput = 2;
constexpr int kInterrupted = 75;

int say(const char* sentence, int code) {
  std::fprintf(stderr, "%s\n", sentence);
  return code;
}

/// False as well while the wrong value of the variable is reported.
bool wants_json_messages() {
  try {
    return messages_are_json();
  } catch (const BadInput&) {
    return false;
  }
}

int say_no_memory() {
  tell_no_memory();
  return kFailed;
}

/// For places that must not throw.
[[noreturn]] void end_without_memory() {
  say_no_memory();
  CallPage::close(kFailed);
  _exit(kFailed);
}

/// The C library loads its unwinder at the first use and ends the process if there is no memory for it by then.
void load_unwinder() {
  void* frame = nullptr;
  backtrace(&frame, 1);
}

/// Whether what was printed has arrived.
bool output_has_arrived() {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.flush().good() &&
         exact_output().flush().good();
}

int end_of_output() {
  if (output_has_arrived()) return 0;
  return say(
      "standard output: the output is incomplete, because not all of it could be written; make room, or redirect it to "
      "another place",
      kFailed);
}

/// A long output fails while it is printed, by an exception that does not know which file it was.
int complain(const std::exception& error, int code) {
  if (!output_has_arrived()) return end_of_output();
  if (!wants_json_messages()) return say(error.what(), code);
  const auto* const bad = dynamic_cast<const BadInput*>(&error);
  exact_errors() << (bad != nullptr ? problem_messages(*bad) : failure_message(error.what())) << std::flush;
  return code;
}

/// CLI11 prints what a flag stands for without its value, as in --json{}, and what it excludes as if it were its value.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    const std::string name = CLI::Formatter::make_option_name(option, is_positional);
    return name.substr(0, name.find('{'));
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string& text = option->get_option_text();
    if (text.starts_with("[=") || option->get_items_expected_max() == 0) return text;
    return CLI::Formatter::make_option_opts(option);
  }
};

using AddCommand = void (*)(CLI::App&);

/// In the order of the help.
constexpr AddCommand kCommands[] = {
    add_check_command,   add_new_command,    add_trial_command,   add_run_command,      add_runs_command,
    add_predict_command, add_plot_command,   add_curves_command,  add_replay_command,   add_reproduce_command,
    add_hash_command,    add_fit_command,    add_compare_command, add_diagnose_command, add_add_command,
    add_undo_command,    add_export_command, add_history_command, add_plugins_command,  add_plan_command,
    add_task_command,    add_status_command, add_merge_command,   add_backup_command,   add_verify_command,
    add_sql_command,     add_report_command, add_serve_command,   add_mcp_command,      add_completion_command,
    add_man_command,     add_help_command};

void add_commands(CLI::App& program) {
  program.require_subcommand(1);
  program.formatter(std::make_shared<HelpFormatter>());
  program.footer(
      "Exit codes: 0 done, 1 failed, 2 bad input, 75 interrupted: run the command again (lacuna "
      "run: with --resume).");
  program.set_version_flag("--version", std::string(LACUNA_VERSION));
  for (const AddCommand add : kCommands) add(program);
}

/// What holds for the whole process, and not for one command.
void prepare_process(int argc, char** argv) {
  load_unwinder();
  set_end_without_memory(&end_without_memory);
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is a failed write, which says so
  set_command_line(argc, argv);
  PluginLibrary::forget_process();
  forget_command_files();
  watch_for_interrupts();
  begin_evaluation_limit();
}

/// Its exit code.
int parse_and_run(CLI::App& program, int argc, char** argv) try {
  messages_are_json();  // complains of LACUNA_MESSAGES before any work is done
  enter_file_sandbox();
  prepare_limits();
  dense_kernels();  // complains of LACUNA_KERNELS before any work is done
  if (const auto explained = command_to_explain(program, argc, argv))
    std::fputs(help_text(program, *explained).c_str(), stdout);
  else
    program.parse(argc, argv);
  return end_of_output();
} catch (const CLI::Success& help_or_version) {
  return program.exit(help_or_version) == 0 ? end_of_output() : kFailed;
} catch (const CLI::ParseError& error) {
  return complain(BadInput(std::vector<Problem>{{{}, usage_sentence(program, error, argc, argv)}}), kBadInput);
} catch (const BadInput& error) {
  return complain(error, kBadInput);
} catch (const Interrupted& error) {
  return complain(error, kInterrupted);
} catch (const std::bad_alloc&) {
  return say_no_memory();
} catch (const std::filesystem::filesystem_error& error) {
  const std::string what = plain_text(error.path1().string()) + ": " + error.code().message();
  return complain(Error(what + "; check the name and the permissions"), kFailed);
} catch (const std::exception& error) {
  return complain(Error(failure_sentence(error)), kFailed);
}

}  // namespace

int run_program(int argc, char** argv) try {
  CLI::App program("Finds the physical effect that a robot model is missing.", "lacuna");
  add_commands(program);
  prepare_process(argc, argv);
  return parse_and_run(program, argc, argv);
} catch (const std::bad_alloc&) {  // while that was said
  return say_no_memory();
}

}  // namespace lacuna
