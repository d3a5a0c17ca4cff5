#include "end_to_end/program.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = LACUNA_BINARY_DIRECTORY "/bin/lacuna";
constexpr const char* kExperiments = LACUNA_SOURCE_DIRECTORY "/experiments";

fs::path new_folder() {
  std::string pattern = (fs::path(testing::TempDir()) / "lacuna-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder could be made");
  return pattern;
}

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Between fork and exec only what is safe there.
[[noreturn]] void become(const char* program, char* const* arguments, const char* folder, int output, int errors) {
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  if (chdir(folder) == 0) execv(program, arguments);
  _exit(127);
}

}  // namespace

Program::Program() : folder_(new_folder()), programs_(LACUNA_BINARY_DIRECTORY "/bin"), captured_(new_folder()) {}

Program::~Program() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  fs::remove_all(captured_, ignored);
}

void Program::copy_experiment(const std::string& experiment, const std::string& robot, const std::string& data) const {
  fs::create_directories(folder_ / "robots");
  fs::create_directories(folder_ / "data");
  fs::copy(fs::path(kExperiments) / experiment, folder_);
  fs::copy(fs::path(kExperiments) / "robots" / robot, folder_ / "robots");
  fs::copy(fs::path(kExperiments) / "data" / data, folder_ / "data" / data);
}

void Program::copy_servo_pendulum() const {
  copy_experiment("servo-pendulum.toml", "servo-pendulum.toml", "servo_pendulum");
}
void Program::copy_first_steps() const { copy_experiment("first-steps.toml", "servo-pendulum.toml", "servo_pendulum"); }
void Program::write_loads() const {
  write("loads.toml", R"([experiment]
name = "loads"
[target]
kind = "recorded"
[[target.recording]]
file = "data/servo_pendulum/sine.csv"
set = { "body.arm.mass" = "0.53 kg" }
[[target.recording]]
file = "data/servo_pendulum/steps.csv"
set = { "body.arm.mass" = "0.56 kg" }
[target.time]
column = "t_s"
use = [[0.0, 4.0]]
[target.sensors]
angle = { column = "angle_deg", unit = "deg" }
[target.commands]
motor = { column = "torque_Nm", unit = "N*m" }
[model]
file = "robots/servo-pendulum.toml"
free = { "joint.hinge.damping" = [0.0, 0.2] }
[engine]
step = "2 ms"
[estimation]
ensemble = 3
[fit]
method = "free_run"
starts = 1
)");
}
void Program::copy_damped_flap() const { copy_experiment("damped-flap.toml", "damped-flap.toml", "damped_flap"); }
void Program::copy_lifting_servo() const {
  copy_experiment("lifting-servo.toml", "lifting-servo.toml", "lifting_servo");
}

Outcome Program::install(const std::string& prefix) {
  Outcome outcome = shell("cmake --install " LACUNA_BINARY_DIRECTORY " --prefix " + prefix);
  programs_ = folder_ / prefix / "bin";
  return outcome;
}

void Program::copy_smoke() const { fs::copy(fs::path(kExperiments) / "smoke", folder_ / "smoke"); }

void Program::copy_bags() const {
  for (const char* file : {"arm.urdf", "arm.db3", "dog.xml", "leg.mcap", "leg.toml"})
    fs::copy(fs::path(kExperiments) / "bags" / file, folder_);
}

void Program::copy_classroom() const {
  for (const char* file : {"session.csv", "video.txt"}) fs::copy(fs::path(kExperiments) / "classroom" / file, folder_);
}

void Program::copy_outside_targets() const {
  for (const char* file : {"outside-pendulum.toml", "outside-cart-pole.toml"})
    fs::copy(fs::path(kExperiments) / file, folder_);
  for (const char* subfolder : {"robots", "targets"})
    fs::copy(fs::path(kExperiments) / subfolder, folder_ / subfolder, fs::copy_options::recursive);
}

void Program::copy_light_servo_pendulum() const {
  copy_servo_pendulum();
  std::string text = read("servo-pendulum.toml");
  text = std::regex_replace(text, std::regex("starts = 2"), "starts = 1");
  write("servo-pendulum.toml", text);
}

void Program::write(const std::string& file, const std::string& text) const {
  std::ofstream(folder_ / file, std::ios::binary) << text;
}

std::string Program::read(const std::string& file) const { return content(folder_ / file); }

pid_t Program::start(const std::vector<std::string>& arguments) const {
  std::vector<std::string> words = {"lacuna"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return start_program(kProgram, words);
}

pid_t Program::start_program(const std::string& program, std::vector<std::string> words) const {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  constexpr int kHow = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC;
  const int output = open((captured_ / "output").c_str(), kHow, 0600);
  const int errors = open((captured_ / "errors").c_str(), kHow, 0600);
  const pid_t child = fork();
  if (child == 0) become(program.c_str(), pointers.data(), folder_.c_str(), output, errors);
  close(output);
  close(errors);
  if (child < 0) throw std::runtime_error("no process could be started");
  return child;
}

Outcome Program::finish(pid_t child) const {
  int status = 0;
  waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, content(captured_ / "output"), content(captured_ / "errors")};
}

Outcome Program::run(const std::vector<std::string>& arguments) const { return finish(start(arguments)); }

Outcome Program::shell(const std::string& line) const {
  const std::string compiler = "export CXX='" LACUNA_COMPILER "' CXXFLAGS='" LACUNA_COMPILER_FLAGS "'; ";
  return finish(start_program("/bin/sh", {"sh", "-c", compiler + "PATH=" + programs_.string() + ":$PATH; " + line}));
}

Outcome Program::run_and_signal(const std::vector<std::string>& arguments, const std::function<bool()>& ready,
                                int signal) const {
  const pid_t child = start(arguments);
  constexpr int kPatience = 10000;  // × 1 ms; then it is signalled all the same, and the test sees what happens
  for (int i = 0; i < kPatience && !ready(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, signal);
  return finish(child);
}

Outcome Program::run_and_signal(const std::vector<std::string>& arguments, const std::string& file, int signal) const {
  return run_and_signal(
      arguments, [&] { return fs::exists(folder_ / file); }, signal);
}

bool Program::carries_out(const std::string& database) const {
  return !shell("sqlite3 -readonly " + database + " 'SELECT run FROM claim' 2>/dev/null").output.empty();
}

}  // namespace lacuna
