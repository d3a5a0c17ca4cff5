#pragma once

#include <lacuna/parameter.h>
#include <lacuna/trial.h>

#include <string>
#include <vector>

namespace lacuna {

/// Reads measured trials; the host hands it to targets.
class TrialReader {
 public:
  virtual ~TrialReader() = default;
  /// The experiment's trials, fit files first. Throws `Error` that names file and line.
  virtual std::vector<Trial> read() const = 0;
};

/// Simulates a test on a robot with the hidden truth; the host hands it to targets.
class Simulator {
 public:
  virtual ~Simulator() = default;
  virtual Trial simulate(const Test& test) const = 0;
};

/// A program beside the host that carries tests out, such as a rig's driver or another simulator; the host starts it,
/// speaks to it, and hands it to targets.
class ExternalProgram {
 public:
  virtual ~ExternalProgram() = default;
  /// Throws `Error` that says how the program failed; it is started again for the next test.
  virtual Trial carry_out(const Test& test) = 0;
};

/// What a target may ask of its host; null where the experiment has no use for it.
struct TargetServices {
  const TrialReader* trials = nullptr;
  const Simulator* simulator = nullptr;
  ExternalProgram* program = nullptr;
};

/// The system to be identified. Used by one thread at a time.
class TargetSystem {
 public:
  virtual ~TargetSystem() = default;

  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Trials that exist already; a target that only has these takes no tests.
  virtual std::vector<Trial> recorded(const TargetServices&) const { return {}; }
  virtual bool takes_tests() const = 0;
  /// Carries the test out. Throws `Error` where it cannot.
  virtual Trial carry_out(const Test& test, const TargetServices& services) = 0;
};

}  // namespace lacuna
