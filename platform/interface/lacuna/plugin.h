#pragma once

#include <lacuna/fitness_metric.h>
#include <lacuna/model_encoding.h>
#include <lacuna/mutation_operator.h>
#include <lacuna/objective_metric.h>
#include <lacuna/overridden_hooks.h>
#include <lacuna/physical_effect.h>
#include <lacuna/recording_format.h>
#include <lacuna/robot_definition.h>
#include <lacuna/robot_format.h>
#include <lacuna/search_strategy.h>
#include <lacuna/target_system.h>
#include <lacuna/test_encoding.h>
#include <lacuna/test_fitness.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

/// The border between host and plugin. A plugin library exports one C symbol, `lacuna_plugin`, which returns a
/// `PluginTable`: plain data that the host checks before it calls any C++ of the library. `LACUNA_PLUGIN` defines both.
namespace lacuna {

/// Raised by every change in this folder that affects built plugins.
inline constexpr std::uint32_t kInterfaceVersion = 12;
inline constexpr char kPluginMagic[8] = {'L', 'A', 'C', 'U', 'N', 'A', 'P', '\0'};
inline constexpr const char* kPluginSymbol = "lacuna_plugin";

struct TypeLayout {
  const char* type;
  std::uint64_t size;
  std::uint64_t alignment;
};

/// `kind` is the interface class's name in lower_snake, as in `ComponentKind` below. `create` returns a `new` object as
/// a pointer to that class, cast to void*; the host owns it until the process ends.
struct ComponentEntry {
  const char* kind;
  const char* name;
  void* (*create)();
};

struct PluginTable {
  char magic[8];
  std::uint32_t interface_version;
  std::uint32_t table_size;      ///< sizeof(PluginTable)
  const char* compiler;          ///< as in "g++ 12"
  const char* standard_library;  ///< as in "libstdc++ cxx11-abi 1"
  const TypeLayout* layouts;
  std::uint64_t layout_count;
  const char* build_id;  ///< free text: version or commit the plugin was built from
  const ComponentEntry* components;
  std::uint64_t component_count;
};

#define LACUNA_TEXT_(x) #x
#define LACUNA_TEXT(x) LACUNA_TEXT_(x)
#if defined(__clang__)
#define LACUNA_COMPILER "clang++ " LACUNA_TEXT(__clang_major__)
#else
#define LACUNA_COMPILER "g++ " LACUNA_TEXT(__GNUC__)
#endif
#if defined(_LIBCPP_VERSION)
#define LACUNA_STANDARD_LIBRARY "libc++ " LACUNA_TEXT(_LIBCPP_ABI_VERSION)
#else
#define LACUNA_STANDARD_LIBRARY "libstdc++ cxx11-abi " LACUNA_TEXT(_GLIBCXX_USE_CXX11_ABI)
#endif
#ifndef LACUNA_BUILD_ID
#define LACUNA_BUILD_ID "unknown"
#endif

#define LACUNA_LAYOUT_(type) \
  TypeLayout { #type, sizeof(type), alignof(type) }
/// Size and alignment of every type that host and plugin exchange.
inline constexpr TypeLayout kInterfaceLayouts[] = {
    LACUNA_LAYOUT_(std::string),
    LACUNA_LAYOUT_(Eigen::Vector3d),
    LACUNA_LAYOUT_(Eigen::Quaterniond),
    LACUNA_LAYOUT_(TimeSeries),
    LACUNA_LAYOUT_(ParameterDeclaration),
    LACUNA_LAYOUT_(ShapeSpec),
    LACUNA_LAYOUT_(BodySpec),
    LACUNA_LAYOUT_(JointSpec),
    LACUNA_LAYOUT_(TransmissionSpec),
    LACUNA_LAYOUT_(ActuatorSpec),
    LACUNA_LAYOUT_(SensorSpec),
    LACUNA_LAYOUT_(ContactSpec),
    LACUNA_LAYOUT_(RobotSpec),
    LACUNA_LAYOUT_(RobotRequest),
    LACUNA_LAYOUT_(RobotText),
    LACUNA_LAYOUT_(ReadRobot),
    LACUNA_LAYOUT_(RecordedTable),
    LACUNA_LAYOUT_(RecordingContents),
    LACUNA_LAYOUT_(TableQuery),
    LACUNA_LAYOUT_(RecordedRows),
    LACUNA_LAYOUT_(ReadRows),
    LACUNA_LAYOUT_(RobotToWrite),
    LACUNA_LAYOUT_(WrittenRobot),
    LACUNA_LAYOUT_(EffectDescription),
    LACUNA_LAYOUT_(EffectStages),
    LACUNA_LAYOUT_(OverriddenHooks),
    LACUNA_LAYOUT_(PhysicalEffect),
    LACUNA_LAYOUT_(EffectContext),
    LACUNA_LAYOUT_(StepView),
    LACUNA_LAYOUT_(JointLoad),
    LACUNA_LAYOUT_(BodyLoad),
    LACUNA_LAYOUT_(StepLoads),
    LACUNA_LAYOUT_(Test),
    LACUNA_LAYOUT_(Trial),
    LACUNA_LAYOUT_(TargetServices),
    LACUNA_LAYOUT_(ComparisonShape),
    LACUNA_LAYOUT_(RandomStream),
    LACUNA_LAYOUT_(Gene),
    LACUNA_LAYOUT_(GenomeLayout),
    LACUNA_LAYOUT_(FreeParameter),
    LACUNA_LAYOUT_(ModelEffect),
    LACUNA_LAYOUT_(ModelSpace),
    LACUNA_LAYOUT_(ModelProposal),
    LACUNA_LAYOUT_(TestSpace),
    LACUNA_LAYOUT_(SearchTask),
    LACUNA_LAYOUT_(Individual),
    LACUNA_LAYOUT_(ScoredIndividual),
    LACUNA_LAYOUT_(TestPrediction),
    LACUNA_LAYOUT_(ObjectiveScore),
    LACUNA_LAYOUT_(HiddenTruth),
};
#undef LACUNA_LAYOUT_

/// The names of an interface class in a plugin's table (`name`) and in messages (`noun`).
template <class Interface>
struct ComponentKind;
template <>
struct ComponentKind<PhysicalEffect> {
  static constexpr const char* name = "physical_effect";
  static constexpr const char* noun = "effect";
};
template <>
struct ComponentKind<RobotDefinition> {
  static constexpr const char* name = "robot_definition";
  static constexpr const char* noun = "robot";
};
template <>
struct ComponentKind<RobotFormat> {
  static constexpr const char* name = "robot_format";
  static constexpr const char* noun = "robot format";
};
template <>
struct ComponentKind<RecordingFormat> {
  static constexpr const char* name = "recording_format";
  static constexpr const char* noun = "recording format";
};
template <>
struct ComponentKind<TargetSystem> {
  static constexpr const char* name = "target_system";
  static constexpr const char* noun = "target";
};
template <>
struct ComponentKind<FitnessMetric> {
  static constexpr const char* name = "fitness_metric";
  static constexpr const char* noun = "metric";
};
template <>
struct ComponentKind<ModelEncoding> {
  static constexpr const char* name = "model_encoding";
  static constexpr const char* noun = "model encoding";
};
template <>
struct ComponentKind<TestEncoding> {
  static constexpr const char* name = "test_encoding";
  static constexpr const char* noun = "test encoding";
};
template <>
struct ComponentKind<MutationOperator> {
  static constexpr const char* name = "mutation_operator";
  static constexpr const char* noun = "mutation";
};
template <>
struct ComponentKind<SearchStrategy> {
  static constexpr const char* name = "search_strategy";
  static constexpr const char* noun = "search";
};
template <>
struct ComponentKind<TestFitness> {
  static constexpr const char* name = "test_fitness";
  static constexpr const char* noun = "test fitness";
};
template <>
struct ComponentKind<ObjectiveMetric> {
  static constexpr const char* name = "objective_metric";
  static constexpr const char* noun = "objective metric";
};

template <class Interface, class Component>
void* make_component() {
  Interface* made = new Component();
  if constexpr (std::is_same_v<Interface, PhysicalEffect>) made->set_overridden(overridden_hooks<Component>());
  return made;
}

/// An entry of the component list: `component<PhysicalEffect, ViscousFriction>("viscous_friction")`.
template <class Interface, class Component>
constexpr ComponentEntry component(const char* name) {
  return {ComponentKind<Interface>::name, name, &make_component<Interface, Component>};
}

}  // namespace lacuna

/// Used once in a plugin library, outside any namespace, with its components as arguments.
#define LACUNA_PLUGIN(...)                                                                                        \
  extern "C" __attribute__((visibility("default"))) const lacuna::PluginTable* lacuna_plugin() {                  \
    static constexpr lacuna::ComponentEntry components[] = {__VA_ARGS__};                                         \
    static constexpr lacuna::PluginTable table = {{'L', 'A', 'C', 'U', 'N', 'A', 'P', '\0'},                      \
                                                  lacuna::kInterfaceVersion,                                      \
                                                  sizeof(lacuna::PluginTable),                                    \
                                                  LACUNA_COMPILER,                                                \
                                                  LACUNA_STANDARD_LIBRARY,                                        \
                                                  lacuna::kInterfaceLayouts,                                      \
                                                  sizeof(lacuna::kInterfaceLayouts) / sizeof(lacuna::TypeLayout), \
                                                  LACUNA_BUILD_ID,                                                \
                                                  components,                                                     \
                                                  sizeof(components) / sizeof(lacuna::ComponentEntry)};           \
    return &table;                                                                                                \
  }
