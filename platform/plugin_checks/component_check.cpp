#include "plugin_checks/component_check.h"

#include "foundation/text/counted.h"
#include "loading/allocation_count.h"
#include "loading/component_kinds.h"
#include "loading/conformance.h"
#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/failures.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <memory>
#include <thread>

namespace lacuna {
namespace {

constexpr int kThreads = 2, kGoesOfAThread = 3;

/// Whether `declarations` is complete.
std::string missing_text(const std::string& summary, const ParameterDeclarations& parameters) {
  if (summary.empty()) return "it has no summary";
  for (const ParameterDeclaration& parameter : parameters)
    if (parameter.description.empty()) return "its parameter \"" + parameter.name + "\" has no description";
  return {};
}

/// Calls a function of the component under a name that is reported if the call ends the process.
template <class Call>
auto called(const char* name, const Call& function) {
  const PluginCall call(own_call_slot().component, name);
  return function();
}

template <class Interface>
std::string declaration_fault(const Interface& component, std::size_t& parameters) {
  if constexpr (std::is_same_v<Interface, PhysicalEffect>) {
    const EffectDescription description = called("describe", [&] { return component.describe(); });
    parameters = description.parameters.size();
    const std::string problem =
        effect_problem(description, called("stages", [&] { return component.stages(); }), component.overridden());
    if (!problem.empty()) return problem;
    if (description.equation.empty()) return "it has no equation";
    return missing_text(description.summary, description.parameters);
  } else if constexpr (std::is_same_v<Interface, RobotFormat>) {
    const std::string problem = endings_problem(called("endings", [&] { return component.endings(); }), ".toml");
    return problem.empty() ? missing_text(called("summary", [&] { return component.summary(); }), {}) : problem;
  } else if constexpr (std::is_same_v<Interface, RecordingFormat>) {
    const std::string problem = endings_problem(called("endings", [&] { return component.endings(); }), ".csv");
    return problem.empty() ? missing_text(called("summary", [&] { return component.summary(); }), {}) : problem;
  } else {
    const ParameterDeclarations declared = called("parameters", [&] { return component.parameters(); });
    parameters = declared.size();
    const std::string problem = declaration_problem(declared);
    return problem.empty() ? missing_text(called("summary", [&] { return component.summary(); }), declared) : problem;
  }
}

/// A component and its exercise.
struct Made {
  std::shared_ptr<const void> component;
  std::unique_ptr<Exercise> exercise;
};

template <class Interface>
std::unique_ptr<Interface> make(const ComponentEntry& entry) {
  const PluginCall call(own_call_slot().component, "its factory");
  std::unique_ptr<Interface> made(static_cast<Interface*>(entry.create()));
  if (made == nullptr) throw Error("its factory returned nothing");
  return made;
}

Made exercised(const ComponentEntry& entry, const ExerciseInputs& inputs) {
  Made made;
  for_component_kind(entry.kind, [&]<class Interface>(std::type_identity<Interface>) {
    if constexpr (std::is_same_v<Interface, TargetSystem>) {
      made.exercise = exercise_of_target([&entry] { return make<TargetSystem>(entry); }, inputs);
    } else {
      const std::shared_ptr<const Interface> component = make<Interface>(entry);
      made.component = component;
      made.exercise = exercise_of(*component, inputs);
    }
  });
  return made;
}

CheckResult passed(const std::string& check, const std::string& finding) {
  return {check, CheckOutcome::passed, finding, {}, {}};
}

CheckResult not_applicable(const std::string& check, const std::string& finding) {
  return {check, CheckOutcome::not_applicable, finding, {}, {}};
}

CheckResult check_declarations(const ComponentEntry& entry) {
  std::string fault;
  std::size_t parameters = 0;
  for_component_kind(entry.kind, [&]<class Interface>(std::type_identity<Interface>) {
    fault = declaration_fault(*make<Interface>(entry), parameters);
  });
  return fault.empty() ? passed("declarations", counted(parameters, "parameter")) : failed_check("declarations", fault);
}

CheckResult check_promises(const Exercise& exercise) {
  const std::vector<std::string> broken = exercise.broken_promises();
  if (!broken.empty())
    return failed_check(
        "promises",
        broken.front() + (broken.size() > 1 ? fmt::format(" (and {} more)", broken.size() - 1) : std::string()));
  const std::string reservation = exercise.reservation();
  return passed("promises", reservation);
}

Transcript transcript_of(const Exercise& exercise) {
  Transcript transcript;
  exercise.go(exercise.settings().front(), transcript);
  return transcript;
}

CheckResult check_determinism(const Exercise& exercise) {
  const Transcript first = transcript_of(exercise), second = transcript_of(exercise);
  const std::string difference = Transcript::first_difference(first, second);
  if (difference.empty()) return passed("determinism", fmt::format("{} numbers, the same in both calls", first.size()));
  const std::string finding = difference + " returned other numbers the second time, from the same arguments";
  return exercise.promises_same_numbers() ? failed_check("determinism", finding)
                                          : not_applicable("determinism", finding + ", which is allowed for a rig");
}

/// The differences that each thread found from `alone`; empty: none.
std::array<std::string, kThreads> differences_in_threads(const Exercise& exercise, const Transcript& alone,
                                                         const ComponentOrigin& origin) {
  std::array<std::string, kThreads> differences;
  std::atomic<int> waiting = kThreads;
  const auto work = [&](std::string& difference) {
    const PluginCall call(on_page(origin), "its calls in two threads");
    --waiting;
    while (waiting > 0) std::this_thread::yield();
    try {
      for (int go = 0; go < kGoesOfAThread && difference.empty(); ++go)
        difference = Transcript::first_difference(alone, transcript_of(exercise));
    } catch (...) {
      difference = thrown_by_call(origin);
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::string& difference : differences) threads.emplace_back([&work, &difference] { work(difference); });
  }
  return differences;
}

CheckResult check_threads(const Exercise& exercise, const ComponentOrigin& origin) {
  const Transcript alone = transcript_of(exercise);
  if (!Transcript::first_difference(alone, transcript_of(exercise)).empty())
    return not_applicable("two threads", "its results differ from call to call");
  for (const std::string& difference : differences_in_threads(exercise, alone, origin))
    if (!difference.empty())
      return failed_check("two threads",
                          difference + " returned other numbers while another thread called the component");
  return passed("two threads", fmt::format("{} calls in each, the same numbers", kGoesOfAThread));
}

std::vector<CheckResult::Figure> figures_of(const std::vector<RepeatedCall>& calls) {
  constexpr double kNano = 1e9;
  std::vector<CheckResult::Figure> figures;
  for (const RepeatedCall& call : calls) figures.push_back({call.name, call.allocations, kNano * call.seconds});
  return figures;
}

std::string counted_times(long count) { return count == 1 ? "once" : fmt::format("{} times", count); }

CheckResult check_allocation(const Exercise& exercise) {
  const std::vector<RepeatedCall> calls = exercise.repeated_calls();
  std::string allowed, free;
  for (const RepeatedCall& call : calls) {
    if (!call.may_allocate && call.allocations > 0)
      return failed_check("allocation",
                          fmt::format("{} allocates memory, {} per call", call.name, counted_times(call.allocations)));
    std::string& list = call.may_allocate ? allowed : free;
    list += (list.empty() ? "" : ", ") + (call.may_allocate ? fmt::format("{} in {}", call.allocations, call.name)
                                                            : fmt::format("0 in {}", call.name));
  }
  CheckResult result = free.empty() ? not_applicable("allocation", allowed.empty() ? "no call is repeated in a step"
                                                                                   : allowed + ", which is allowed")
                                    : passed("allocation", free);
  result.figures = figures_of(calls);
  return result;
}

/// " at the values 0, 1 of its parameters"; empty: it has none.
std::string place_of(const Setting& setting) {
  std::string values;
  for (const double value : setting) values += fmt::format("{}{:g}", values.empty() ? "" : ", ", value);
  return values.empty() ? values : " at the values " + values + " of its parameters";
}

CheckResult check_finite(const Exercise& exercise, const ComponentOrigin& origin) {
  std::size_t seen = 0, refused = 0;
  for (const Setting& setting : exercise.settings()) {
    Transcript transcript;
    try {
      exercise.go(setting, transcript);
    } catch (const Error&) {
      if (seen == 0) throw;
      ++refused;  // a combination that the component refuses
    } catch (...) {
      return failed("finite numbers", kThrownReason, thrown_by_call(origin) + place_of(setting));
    }
    ++seen;
    if (!transcript.not_finite().empty())
      return failed_check("finite numbers", transcript.not_finite() + place_of(setting));
  }
  return passed("finite numbers", fmt::format("at {} of its parameters{}", counted(seen, "setting"),
                                              refused > 0 ? fmt::format(", {} refused", refused) : ""));
}

std::string duration_text(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:.3g} ns", nanoseconds);
  if (nanoseconds < 1e6) return fmt::format("{:.3g} µs", 1e-3 * nanoseconds);
  return fmt::format("{:.3g} ms", 1e-6 * nanoseconds);
}

CheckResult check_time(const Exercise& exercise) {
  CheckResult result = passed("time", "");
  result.figures = figures_of(exercise.repeated_calls());
  for (const CheckResult::Figure& figure : result.figures)
    result.finding +=
        fmt::format("{}{} {}", result.finding.empty() ? "" : ", ", figure.call, duration_text(figure.nanoseconds));
  if (result.figures.empty()) return not_applicable("time", "no call is repeated");
  result.finding += ", median";
  return result;
}

CheckResult carry_out(const ComponentEntry& entry, const ComponentOrigin& origin, const std::string& check,
                      const ExerciseInputs& inputs) {
  if (check == "declarations") return check_declarations(entry);
  const Made made = exercised(entry, inputs);
  if (check == "promises") return check_promises(*made.exercise);
  if (check == "determinism") return check_determinism(*made.exercise);
  if (check == "two threads") return check_threads(*made.exercise, origin);
  if (check == "allocation") return check_allocation(*made.exercise);
  if (check == "finite numbers") return check_finite(*made.exercise, origin);
  return check_time(*made.exercise);
}

}  // namespace

const std::vector<std::string>& component_check_names() {
  static const std::vector<std::string> names = {"declarations", "promises",       "determinism", "two threads",
                                                 "allocation",   "finite numbers", "time"};
  return names;
}

CheckResult check_component(const ComponentEntry& component, const ComponentOrigin& origin, const std::string& check,
                            const ExerciseInputs& inputs) {
  const PluginCall call(on_page(origin), "its calls");
  ProcessWatch::look_closely();
  count_allocations();
  try {
    CheckResult result = carry_out(component, origin, check, inputs);
    throw_if_process_changed("a call");
    return result;
  } catch (const ProcessChanged& change) {
    return failed(check, "promises", change.deed());
  } catch (const Error& error) {
    return failed(check, kRefusedReason, std::string("it refuses its own defaults: ") + error.what());
  } catch (...) {
    return failed(check, kThrownReason, thrown_by_call(origin));
  }
}

std::string transcript_digest(const ComponentEntry& component, const ComponentOrigin& origin,
                              const ExerciseInputs& inputs) {
  const PluginCall call(on_page(origin), "its calls");
  return transcript_of(*exercised(component, inputs).exercise).digest();
}

}  // namespace lacuna
