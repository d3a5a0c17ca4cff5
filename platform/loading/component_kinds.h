#pragma once

#include <lacuna/plugin.h>

#include <string>
#include <string_view>
#include <type_traits>

namespace lacuna {

/// Calls `visit(std::type_identity<Interface>())` for every kind of component.
template <class Visitor>
void for_each_component_kind(Visitor&& visit) {
  visit(std::type_identity<PhysicalEffect>());
  visit(std::type_identity<RobotDefinition>());
  visit(std::type_identity<RobotFormat>());
  visit(std::type_identity<RecordingFormat>());
  visit(std::type_identity<TargetSystem>());
  visit(std::type_identity<FitnessMetric>());
  visit(std::type_identity<ModelEncoding>());
  visit(std::type_identity<TestEncoding>());
  visit(std::type_identity<MutationOperator>());
  visit(std::type_identity<SearchStrategy>());
  visit(std::type_identity<TestFitness>());
  visit(std::type_identity<ObjectiveMetric>());
}

/// The same for the kind with this name in a plugin's table; nothing happens where there is none.
template <class Visitor>
void for_component_kind(std::string_view kind, Visitor&& visit) {
  for_each_component_kind([&]<class Interface>(std::type_identity<Interface> type) {
    if (kind == ComponentKind<Interface>::name) visit(type);
  });
}

/// What users call a component of this kind: "effect" for "physical_effect"; empty: no such kind.
inline std::string component_noun(std::string_view kind) {
  std::string noun;
  for_component_kind(kind,
                     [&]<class Interface>(std::type_identity<Interface>) { noun = ComponentKind<Interface>::noun; });
  return noun;
}

}  // namespace lacuna
