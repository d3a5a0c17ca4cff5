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
        "Correct what describe(), parameters() or summary() return."}},
      {"promises",
       {"The program relies on what the interface promises and gives wrong results without it.",
        "Read the interface's header, correct the component, and check again."}},
      {"determinism",
       {"A run is to be reproduced and resumed to the bit; a fit of a function that wavers does not converge.",
        "Take random numbers from the stream that the call gets, keep what must be remembered in the host's state, and "
        "read no clock, address or uninitialised memory."}},
      {"two threads",
       {"Lacuna shares the component between its threads; results would depend on --threads.",
        "Take writable static and mutable members out, or make them thread_local."}},
      {"allocation",
       {"The call is repeated millions of times; each model that uses it becomes slower.",
        "Keep what it needs in its state, or in arrays of fixed size."}},
      {"finite numbers",
       {"One NaN or infinity makes the whole evaluation invalid.",
        "Narrow the declared bounds to what the formula can take, or guard the division, root or logarithm."}},
      {kThrownReason,
       {"Only lacuna::Error tells a user what to do; anything else counts as a fault of the plugin and ends the "
        "command.",
        "Throw lacuna::Error with a sentence where the call cannot go on, or correct the call."}},
      {kEndedReason,
       {"A plugin that ends or holds its process ends the command, or a run's worker, that called it.",
        "Make the call in a small program of your own, with a debugger or -fsanitize=address,undefined."}},
      {kRefusedReason,
       {"Defaults are what a user gets who says nothing.", "Let the component take its own defaults."}}};
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
