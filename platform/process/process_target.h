#pragma once

#include <lacuna/target_system.h>
#include <lacuna/test_encoding.h>

#include "foundation/text/problem.h"
#include "foundation/processes/process_source.h"
#include "foundation/processes/stop.h"
#include "process/hello.h"
#include "process/trial_messages.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

class ChildLines;

/// The model's names, units and limits, which the program must match.
struct ProcessTargetSetting {
  ProcessSource source;
  SourceLocation location;               ///< of the command in the experiment file
  TestSpace space;                       ///< what the model reads and drives, and how often
  std::vector<std::string> coordinates;  ///< the joint of each of the model's coordinates; empty: not told apart
  std::uint64_t noise_seed = 1;          ///< keys the seeds that the target is given
  std::function<void(const std::string&)> note = {};  ///< is told what a user should know, a sentence each
  Stop stop = {};                                     ///< ends a wait for the program early
};

/// A target that is another program, spoken to in lines of JSON (docs/reference/process-target.md). It is started when
/// it is first needed, serves trial after trial, is ended when a trial fails or this object does, and is started again
/// for the next. One thread at a time.
class ProcessTarget : public ExternalProgram {
 public:
  explicit ProcessTarget(ProcessTargetSetting setting);
  ~ProcessTarget() override;

  /// What the target says of itself. Throws `BadInput` with everything in which it does not fit the model.
  const Hello& hello();
  /// The next trial is the `number`th, which keys its seed.
  void begin_trial(std::uint64_t number) { number_ = number; }
  /// Throws `Error` with a sentence that says how the program failed, and the last words that it wrote to standard
  /// error; `BadInput` where it cannot be started or does not fit the model, though one that once did fails with an
  /// `Error`; `Interrupted` when `stop` is due.
  Trial carry_out(const Test& test) override;

 private:
  template <class Call>
  decltype(auto) guarded(const std::string& limit, Call&& call);
  [[noreturn]] void fail(const std::string& what);
  void start();
  void start_afresh();
  void greet();
  Trial try_test(const Test& test);

  ProcessTargetSetting setting_;
  std::string program_;  ///< as sentences call it
  Hello hello_;
  std::unique_ptr<ChildLines> lines_;
  std::uint64_t number_ = 0;
  std::uint64_t sent_ = 0;  ///< tests, to all programs that were started
  bool was_fit_ = false;    ///< it has sent its hello, which matches the model
};

}  // namespace lacuna
