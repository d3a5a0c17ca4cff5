#include "formula/force_law.h"
#include "foundation/placement_unit.h"
#include "foundation/unit.h"
#include "residual_law/law_family.h"

#include <gtest/gtest.h>

/// What a diagnosis writes, the language of formulas reads.
namespace lacuna {
namespace {

JointCourse course_of(const std::string& position_unit, const std::string& force_unit) {
  JointCourse course{"joint", position_unit, force_unit, "V", {{}}};
  for (double at = -2.0; at < 2.0; at += 0.04) course.trials[0].push_back({.position = at, .velocity = at});
  return course;
}

RobotSpec robot_of(JointKind kind) {
  RobotSpec robot;
  robot.joints.resize(1);
  robot.joints[0].name = "joint";
  robot.joints[0].kind = kind;
  robot.actuators.resize(1);
  robot.actuators[0].joint = "joint";
  return robot;
}

/// The first parameter's unit on that robot, of a volt where it is of a command.
Unit unit_on(const RobotSpec& robot, std::string declared) {
  const std::string word = "{command}";
  for (std::size_t at = declared.find(word); at != declared.npos; at = declared.find(word))
    declared.replace(at, word.size(), "V");
  const std::optional<Unit> unit = parse_unit(unit_at(declared, robot, ElementKind::joint, 0));
  EXPECT_TRUE(unit) << declared;
  return unit.value_or(Unit{});
}

void expect_every_term_read(JointKind kind, const std::string& position_unit, const std::string& force_unit) {
  const std::vector<ForceTerm> terms = force_terms(course_of(position_unit, force_unit));
  ASSERT_GT(terms.size(), 15U);
  for (const ForceTerm& term : terms) {
    SCOPED_TRACE(term.text);
    const ForceLaw law = read_force_law("-0.0105*" + term.text, {});
    ASSERT_EQ(law.parameters.size(), 1U);
    EXPECT_EQ(law.parameters[0].default_value, -0.0105);
    if (term.unit.find('.') != std::string::npos) continue;  // a root has no unit of its own
    const Unit whole = unit_on(robot_of(kind), law.parameters[0].unit);
    const std::optional<Unit> expected = parse_unit(force_unit + "/(" + term.unit + ")");
    ASSERT_TRUE(expected);
    EXPECT_TRUE(whole.same_dimension(*expected)) << law.parameters[0].unit << " for " << term.unit;
  }
}

TEST(DiagnosedTerms, OfAHingeAreFormulasWithTheirUnits) { expect_every_term_read(JointKind::hinge, "rad", "N*m"); }

TEST(DiagnosedTerms, OfASliderAreFormulasWithTheirUnits) { expect_every_term_read(JointKind::slider, "m", "N"); }

}  // namespace
}  // namespace lacuna
