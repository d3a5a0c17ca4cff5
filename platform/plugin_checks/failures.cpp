#include "plugin_checks/failures.h"

#include "foundation/plugins/plugin_fault.h"

#include <map>

namespace lacuna {
namespace {

struct Meaning {
  const char *why, *remedy;
};

const std::map<std::string, Meaning>& meanings() {
  static const std::map<std::string, Meaning> all = {
      {"declarations",
       {"Files, fits and pages take names, units, bounds and texts from the declaration.",
        "Correct what describe(), parameters() or summary() returns."}},
      {"promises",
       {"The program relies on the rules of the interface and gives wrong results without them.",
        "Read the interface's header, correct the component, and check again."}},
      {"determinism",
       {"A run must be reproducible and resumable to the last bit; a fit of a function that returns other numbers each "
        "time does not converge.",
        "Take random numbers only from the stream of the call, keep memory in the host's state, and read no clock, "
        "address or uninitialised memory."}},
      {"two threads",
       {"Lacuna shares the component between its threads, so results would depend on --threads.",
        "Remove writable static and mutable members, or make them thread_local."}},
      {"allocation",
       {"The call is repeated millions of times, so each model that uses it becomes slower.",
        "Keep the data in its state or in arrays of fixed size."}},
      {"finite numbers",
       {"One NaN or infinity makes the whole evaluation invalid.",
        "Narrow the declared bounds to the valid range of the formula, or guard the division, root or logarithm."}},
      {kThrownReason,
       {"Only lacuna::Error carries a message for the user; any other exception counts as a fault of the plugin and "
        "ends the command.",
        "Throw lacuna::Error with a sentence where the call cannot continue, or correct the call."}},
      {kEndedReason,
       {"A plugin that ends or blocks its process ends the command, or a run's worker, that called it.",
        "Make the call in a small test program, with a debugger or -fsanitize=address,undefined."}},
      {kRefusedReason,
       {"Users who set no parameter get the defaults.", "The component must accept its own defaults."}}};
  return all;
}

}  // namespace

CheckResult failed(const std::string& check, const std::string& reason, const std::string& finding) {
  const Meaning& meaning = meanings().at(reason);
  return {check, CheckOutcome::failed, finding, meaning.why, meaning.remedy};
}

std::string thrown_by_call(const ComponentOrigin& origin) {
  std::string sentence = describe_current_exception(origin, "a call");
  const std::string before = to_string(origin) + ": ";
  if (sentence.starts_with(before)) sentence.erase(0, before.size());
  return sentence.substr(0, sentence.find(kFaultOfPlugin));
}

}  // namespace lacuna
