#include "loading/effect_probe.h"
#include "loading/effect_trial.h"
#include "plugin_checks/exercises/exercises.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kSteps = 20;

/// A kind of element on which the effect can be placed, and the elements on the robot of two links.
struct EffectPlace {
  ElementKind kind;
  std::vector<int> elements;
};

bool is_load(const std::pair<const char*, std::vector<double>>& result) {
  return std::string_view(result.first) == "add_loads";
}

class EffectExercise : public Exercise {
 public:
  explicit EffectExercise(const PhysicalEffect& effect) : effect_(effect), description_(effect.describe()) {
    for (const ElementKind kind : description_.placements)
      for (std::vector<int> elements : {std::vector<int>{0}, std::vector<int>{0, 1}}) {
        if (kind == ElementKind::world) elements.clear();
        if (!takes({kind, elements})) continue;
        places_.push_back({kind, elements});
        break;
      }
  }

  ParameterDeclarations declared() const override { return description_.parameters; }
  /// First values that are not neutral, at which the effect is active.
  std::vector<Setting> settings() const override {
    std::vector<Setting> all = settings_of(description_.parameters);
    all.insert(all.begin(), values_to_try());
    return all;
  }

  void go(const Setting& setting, Transcript& transcript) const override {
    for (const EffectPlace& place : places_) {
      EffectConditions conditions;
      conditions.steps = kSteps;
      conditions.counts_allocations = false;  // each hook once per step, as in a simulation
      const EffectCourse course = trial(place, setting).go(conditions);
      if (course.threw()) std::rethrow_exception(course.thrown);
      for (const auto& result : course.results) write_down(result, course.summands.size(), transcript);
    }
  }

  std::vector<std::string> broken_promises() const override {
    const std::string problem = try_effect(effect_, description_).problem;
    return problem.empty() ? std::vector<std::string>() : std::vector{problem};
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    std::vector<RepeatedCall> calls;
    for (const EffectPlace& place : places_)
      for (const HookCost& cost : trial(place, values_to_try()).costs()) {
        const auto same = [&](const RepeatedCall& call) { return std::string_view(call.name) == cost.call; };
        const auto known = std::find_if(calls.begin(), calls.end(), same);
        if (known == calls.end())
          calls.push_back({cost.call, false, cost.allocations, cost.seconds});
        else
          *known = {cost.call, false, std::max(known->allocations, cost.allocations),
                    std::max(known->seconds, cost.seconds)};
      }
    return calls;
  }

  std::string reservation() const override {
    return places_.empty() ? "it refuses the elements of a robot with two links: " + refusal_ : "";
  }

 private:
  EffectTrial trial(const EffectPlace& place, const Setting& setting) const {
    return {effect_, description_, place.kind, place.elements, setting};
  }
  Setting values_to_try() const {
    Setting values;
    for (const ParameterDeclaration& parameter : description_.parameters) values.push_back(value_to_try(parameter));
    return values;
  }
  /// Some effects act between two elements, or on elements that this robot lacks; they throw an `Error`.
  bool takes(const EffectPlace& place) {
    const EffectCourse course = trial(place, values_to_try()).go({});
    if (!course.threw()) return true;
    try {
      std::rethrow_exception(course.thrown);
    } catch (const Error& error) {
      refusal_ = error.what();
    }
    return false;
  }
  /// Loads must be finite; the stiffness of the ground and values of a robot may be infinite.
  static void write_down(const std::pair<const char*, std::vector<double>>& result, std::size_t loads,
                         Transcript& transcript) {
    const std::span<const double> all = result.second;
    const bool is_robot = std::string_view(result.first) == "amend";
    const std::size_t finite = is_robot ? 0 : is_load(result) ? std::min(loads, all.size()) : all.size();
    transcript.add(result.first, all.first(finite));
    transcript.add(result.first, all.subspan(finite), Transcript::May::be_infinite);
  }

  const PhysicalEffect& effect_;
  EffectDescription description_;
  std::vector<EffectPlace> places_;
  std::string refusal_;
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const PhysicalEffect& effect, const ExerciseInputs&) {
  return std::make_unique<EffectExercise>(effect);
}

}  // namespace lacuna
