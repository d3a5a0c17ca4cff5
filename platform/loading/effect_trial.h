#pragma once

#include <lacuna/physical_effect.h>

#include <bit>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// Two bodies on hinges, one attached to the other, each with a motor and an encoder, above the ground: the robot on
/// which effects are tried.
RobotSpec two_links();

/// Every number of a robot that an effect may amend.
std::vector<double> numbers_of(const RobotSpec& robot);

/// A value that is not the neutral one, within bounds.
double value_to_try(const ParameterDeclaration& parameter);

/// The results of one run through the hooks of an effect.
struct EffectCourse {
  std::vector<std::pair<const char*, std::vector<double>>> results;  ///< by call
  std::vector<double> summands;                                      ///< of the loads in the last step
  bool replaced_loads = false;
  bool kept_to_state = true;
  std::exception_ptr thrown = nullptr;                    ///< by a hook; null: nothing
  std::vector<std::pair<const char*, long>> allocations;  ///< by call, for all calls of a step

  bool threw() const { return thrown != nullptr; }
};

/// Settings by which runs differ.
struct EffectConditions {
  double guard = 0.37;             ///< content of the memory beside the parameters
  bool has_others = false;         ///< whether other effects have added loads before
  bool looks_at_process = false;   ///< whether a change of the process by a call is thrown as `ProcessChanged`
  int steps = 1;                   ///< of 1 ms, in each of which the robot is elsewhere
  bool counts_allocations = true;  ///< call each hook of a step twice
};

/// The cost per call of a hook that is called in a step.
struct HookCost {
  const char* call;
  long allocations = 0;
  double seconds = 0.0;  ///< median
};

/// An effect on elements of the robot of two links, with the given values. Calls its hooks like the simulation, with
/// guard values around their memory.
class EffectTrial {
 public:
  EffectTrial(const PhysicalEffect& effect, const EffectDescription& description, ElementKind kind,
              std::vector<int> elements, std::vector<double> values);

  EffectCourse go(const EffectConditions& conditions) const;
  /// Cost of its hooks of a step. Throws what they throw.
  std::vector<HookCost> costs() const;
  std::size_t parameters() const { return values_.size(); }

 private:
  const PhysicalEffect& effect_;
  ElementKind kind_;
  std::vector<int> elements_;
  std::vector<double> values_;
  std::vector<double> largest_;  ///< of each parameter
};

inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// The first call with a different result; null: none.
const char* first_difference(const EffectCourse& a, const EffectCourse& b);

/// The loads of other effects in a run with them, as `EffectCourse::summands`.
std::vector<double> summands_of_others();

}  // namespace lacuna
