#pragma once

#include <lacuna/parameter.h>
#include <lacuna/trial.h>

#include <string>
#include <vector>

namespace lacuna {

/// Reads measured trials; the host passes it to targets.
class TrialReader {
 public:
  virtual ~TrialReader() = default;
  /// The experiment's trials, fit files first. Throws `Error` with file and line.
  virtual std::vector<Trial> read() const = 0;
};

/// Simulates a test on a robot with the hidden truth; the host passes it to targets.
class Simulator {
 public:
  virtual ~Simulator() = default;
  virtual Trial simulate(const Test& test) const = 0;
};

/// A separate program that carries tests out, such as a rig's driver or another simulator; the host starts it,
/// communicates with it, and passes it to targets.
class ExternalProgram {
 public:
  virtual ~ExternalProgram() = default;
  /// Throws `Error` with the failure of the program; it is started again for the next test.
  virtual Trial carry_out(const Test& test) = 0;
};

/// The host's services for a target; null where the experiment does not use them.
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
  /// Trials that already exist; a target with only such trials takes no tests.
  virtual std::vector<Trial> recorded(const TargetServices&) const { return {}; }
  virtual bool takes_tests() const = 0;
  /// Carries the test out. Throws `Error` where it cannot.
  virtual Trial carry_out(const Test& test, const TargetServices& services) = 0;
};

}  // namespace lacuna
