#include "loading/conformance.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr OverriddenHooks kNoHooks{false, false, false, false, false};

ParameterDeclaration declared(const std::string& name, const std::string& unit, double value, double lower,
                              double upper) {
  return {name, unit, value, lower, upper, Scale::linear, "For a test"};
}

EffectDescription on(std::vector<ElementKind> placements, ParameterDeclarations parameters) {
  EffectDescription description;
  description.placements = std::move(placements);
  description.parameters = std::move(parameters);
  return description;
}

std::string problem(const EffectDescription& description) { return effect_problem(description, {}, kNoHooks); }

TEST(Conformance, SoundDeclarationsPass) {
  EXPECT_THAT(declaration_problem({declared("rate", "N*m/s", 1.0, 0.0, 2.0), declared("fixed", "1", 3.0, 3.0, 3.0)}),
              IsEmpty());
  EXPECT_THAT(problem(on({ElementKind::joint}, {declared("drag", "{force}*s^2/{position}^2", 0.0, 0.0, 1.0)})),
              IsEmpty());
}

TEST(Conformance, NamesAreThereAndDiffer) {
  EXPECT_THAT(declaration_problem({declared("", "1", 0.0, 0.0, 1.0)}), HasSubstr("parameter 1 has no name"));
  EXPECT_THAT(declaration_problem({declared("a.b", "1", 0.0, 0.0, 1.0)}), HasSubstr("letters, digits and _"));
  EXPECT_THAT(declaration_problem({declared("a", "1", 0.0, 0.0, 1.0), declared("a", "m", 0.0, 0.0, 1.0)}),
              HasSubstr("two of its parameters are named \"a\""));
}

TEST(Conformance, BoundsAreNumbersInOrderAroundTheDefault) {
  EXPECT_THAT(declaration_problem({declared("a", "1", 1.0, 2.0, 0.0)}),
              AllOf(HasSubstr("\"a\""), HasSubstr("a lower bound above its upper bound")));
  EXPECT_THAT(declaration_problem({declared("a", "1", 3.0, 0.0, 2.0)}), HasSubstr("a default outside of its bounds"));
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    EXPECT_THAT(declaration_problem({declared("a", "1", bad, 0.0, 1.0)}), HasSubstr("not finite"));
    EXPECT_THAT(declaration_problem({declared("a", "1", 0.0, 0.0, bad)}), HasSubstr("not finite"));
  }
}

TEST(Conformance, UnitsAreKnown) {
  EXPECT_THAT(declaration_problem({declared("a", "N*x", 0.0, 0.0, 1.0)}),
              AllOf(HasSubstr("\"N*x\""), HasSubstr("N*m")));
  EXPECT_THAT(declaration_problem({declared("a", "{force}", 0.0, 0.0, 1.0)}), HasSubstr("\"{force}\""));
}

TEST(Conformance, UnitsOfEffectsAreKnownOnEveryPlacement) {
  EXPECT_THAT(problem(on({ElementKind::joint}, {declared("a", "{foo}", 0.0, 0.0, 1.0)})),
              AllOf(HasSubstr("\"{foo}\""), HasSubstr("{position}, {force}, {inertia}")));
  const ParameterDeclarations of_command = {declared("a", "{command}/s", 0.0, 0.0, 1.0)};
  EXPECT_THAT(problem(on({ElementKind::actuator}, of_command)), IsEmpty());
  EXPECT_THAT(problem(on({ElementKind::actuator, ElementKind::joint}, of_command)), HasSubstr("joint"));
  const ParameterDeclarations of_channel = {declared("a", "1/{channel}", 0.0, 0.0, 1.0)};
  EXPECT_THAT(problem(on({ElementKind::sensor}, of_channel)), IsEmpty());
  EXPECT_THAT(problem(on({ElementKind::world}, of_channel)), HasSubstr("the world"));
}

TEST(Conformance, AnEffectHasAPlacementAndAsManyNeutralValuesAsParameters) {
  EXPECT_THAT(problem(on({}, {})), HasSubstr("has no placement"));
  EffectDescription description = on({ElementKind::body}, {declared("a", "m", 0.0, 0.0, 1.0)});
  description.neutral = {0.0, 1.0};
  EXPECT_THAT(problem(description), HasSubstr("2 neutral values for 1 parameters"));
}

TEST(Conformance, StagesAndOverriddenHooksGoTogether) {
  const EffectDescription description = on({ElementKind::actuator, ElementKind::sensor}, {});
  OverriddenHooks command = kNoHooks, sense = kNoHooks;
  command.command = true;
  sense.sense = true;
  EXPECT_THAT(effect_problem(description, {}, command), AllOf(HasSubstr("`command`"), HasSubstr("CommandStage")));
  EXPECT_THAT(effect_problem(description, {}, sense), AllOf(HasSubstr("`sense`"), HasSubstr("{.sensor = ")));
  EXPECT_THAT(effect_problem(description, {.command = CommandStage::gain}, kNoHooks), HasSubstr("does not override"));
  EXPECT_THAT(effect_problem(description, {.command = CommandStage::gain}, command), IsEmpty());
  EXPECT_THAT(effect_problem(description, {.sensor = SensorStage::scale}, sense), IsEmpty());
}

TEST(Conformance, EndingsOfFilesBeginWithADotAndAreNotTheHosts) {
  EXPECT_EQ(endings_problem({".mcap", ".db3"}, ".csv"), "");
  EXPECT_THAT(endings_problem({}, ".csv"), HasSubstr("names no file ending"));
  EXPECT_THAT(endings_problem({".mcap", "db3"}, ".csv"), HasSubstr("files that end with \"db3\""));
  EXPECT_THAT(endings_problem({".csv"}, ".csv"), HasSubstr(".csv is taken"));
  EXPECT_EQ(endings_problem({".csv"}, ".toml"), "");
}

}  // namespace
}  // namespace lacuna
