#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// What the program did: exit code (128 + signal where a signal ended it) and everything it printed.
struct Outcome {
  int exit_code = 0;
  std::string output;
  std::string errors;
};

/// The `lacuna` program of this build, at work in a folder of its own, which starts empty and ends with the object.
class Program {
 public:
  Program();
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// Copies experiments/servo-pendulum.toml with its robot and recordings.
  void copy_servo_pendulum() const;
  /// The same with one start.
  void copy_light_servo_pendulum() const;
  /// Copies experiments/first-steps.toml with its robot and recordings: a fit of it takes a second or two.
  void copy_first_steps() const;
  /// Writes loads.toml beside what `copy_first_steps` copied: its two recordings, with loads that differ.
  void write_loads() const;
  /// Copies experiments/damped-flap.toml with its robot and recordings.
  void copy_damped_flap() const;
  /// Copies experiments/lifting-servo.toml with its robot and recordings.
  void copy_lifting_servo() const;
  /// Copies the experiments whose target is a program, with their robots and the programs that need no compiler.
  void copy_outside_targets() const;
  /// Installs this build into the subfolder `prefix`, whose `lacuna` is the one that `shell` runs from then on.
  Outcome install(const std::string& prefix);
  /// Copies experiments/smoke/, whose experiments bring no files.
  void copy_smoke() const;
  /// Copies the robots, recordings and the experiment file of experiments/bags/ that guides begin with.
  void copy_bags() const;
  /// Copies the tables of experiments/classroom/ that a guide begins with.
  void copy_classroom() const;
  void write(const std::string& file, const std::string& text) const;
  std::string read(const std::string& file) const;

  /// Runs `lacuna` with these arguments to its end.
  Outcome run(const std::vector<std::string>& arguments) const;
  /// Runs a line as a shell takes it, in which `lacuna` is this build's. CMake takes the compiler of this build.
  Outcome shell(const std::string& line) const;
  /// Starts it, waits until `ready` (looked at every millisecond), sends `signal`, and waits for its end.
  Outcome run_and_signal(const std::vector<std::string>& arguments, const std::function<bool()>& ready,
                         int signal) const;
  /// The same, ready as soon as `file` exists in the folder.
  Outcome run_and_signal(const std::vector<std::string>& arguments, const std::string& file, int signal) const;

  /// Whether a run is carried out in the database.
  bool carries_out(const std::string& database) const;

 private:
  void copy_experiment(const std::string& experiment, const std::string& robot, const std::string& data) const;
  pid_t start(const std::vector<std::string>& arguments) const;
  pid_t start_program(const std::string& program, std::vector<std::string> words) const;
  Outcome finish(pid_t child) const;

  std::filesystem::path folder_;
  std::filesystem::path programs_;  ///< where `lacuna` lies
  std::filesystem::path captured_;  ///< holds what the program prints
};

}  // namespace lacuna
