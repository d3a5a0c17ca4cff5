#include "report/figure.h"

#include "report/figure_script.h"
#include "report/figure_series.h"
#include "report/not_written.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

namespace lacuna {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs gnuplot on a script file; its complaints go to `log`. Returns its exit code, 127 where it is missing.
int run_gnuplot(const std::filesystem::path& script_file, const std::filesystem::path& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  std::string program = "gnuplot", argument = script_file.string();
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failure = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return 127;
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

void check(const Figure& figure) {
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series) {
      const bool sized =
          series.mark == Mark::level
              ? series.y.size() == 1
              : series.x.size() == series.y.size() && (!reaches(series.mark) || series.y2.size() == series.y.size());
      if (!sized)
        throw Error("figure \"" + figure.title + "\": series \"" + series.label + "\" has columns of different length");
    }
}

}  // namespace

void write_svg(const Figure& figure, const std::filesystem::path& file) {
  check(figure);
  if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path());
  const auto beside = [&](const char* ending) { return std::filesystem::path(file.string() + ending); };
  const std::filesystem::path draft = beside(".draft"), commands = beside(".gnuplot"), log = beside(".log");
  if (!(std::ofstream(commands) << gnuplot_script(figure, draft) << std::flush)) {
    std::filesystem::remove(commands);
    throw_not_written(file);
  }
  const int code = run_gnuplot(commands, log);
  const std::string complaints = content_of(log);
  std::filesystem::remove(commands);
  std::filesystem::remove(log);
  if (code == 127)
    throw Error("pictures are drawn by gnuplot, which is not installed; install the package gnuplot-nox");
  if (code != 0 || !std::filesystem::exists(draft))
    throw Error(file.string() + ": gnuplot could not draw it: " + complaints);
  std::filesystem::rename(draft, file);
}

}  // namespace lacuna
