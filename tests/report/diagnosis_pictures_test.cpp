#include "report/figures/diagnosis_pictures.h"

#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

ForceCurve drag(const std::string& joint, const std::string& of, const std::string& unit) {
  ForceCurve curve{joint, of, unit, "N*m", {}, {}, {}};
  for (double v = -8.0; v <= 8.0; v += 1.0) {
    curve.at.push_back(v);
    curve.force.push_back(of == "velocity" ? -0.0105 * v * std::abs(v) : 0.002 * std::sin(v));
    curve.standard_error.push_back(0.01 + 0.001 * std::abs(v));
  }
  return curve;
}

RankedModel ranked(const std::string& effect, double gain, double error) {
  RankedModel model;
  model.effects = {{effect, "joint.hinge", {}}};
  model.gain = {gain, error, gain - 2.0 * error, gain + 2.0 * error};
  return model;
}

Diagnosis not_in_library() {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::not_in_library;
  diagnosis.probability = 0.93;
  diagnosis.ranking = {ranked("viscous_friction", 118.0, 9.0), ranked("coulomb_friction", 61.0, 8.0),
                       ranked("backlash", -4.0, 6.0)};
  for (const char* joint : {"hinge", "wrist"}) diagnosis.residual_force.push_back(drag(joint, "position", "rad"));
  diagnosis.residual_force.push_back(drag("hinge", "velocity", "rad/s"));
  diagnosis.residual_force.push_back(drag("hinge", "command", "N*m"));
  for (const double position : {-0.8, 0.8}) {
    diagnosis.residual_force.push_back(drag("hinge", "velocity", "rad/s"));
    diagnosis.residual_force.back().position = position;
  }
  diagnosis.formulas = {{"hinge", "N*m", {{"v*abs(v)", "rad^2/s^2", -0.0105, 0.0003}}, {}}};
  return diagnosis;
}

TEST(DiagnosisPictures, ShowErrorsByHorizonWhereThoseDecided) {
  const TestFolder folder;
  Diagnosis found;
  found.verdict = Verdict::effect_found;
  found.ranking = {ranked("viscous_friction", 1.8, 0.1)};
  constexpr double kNotHeldOut = std::numeric_limits<double>::quiet_NaN();
  found.horizons = {{0.1, "angle", "rad", 1e-3, 12e-3, 1e-3, kNotHeldOut, kNotHeldOut},
                    {1.0, "angle", "rad", 2e-3, 90e-3, 3e-3, kNotHeldOut, kNotHeldOut}};
  const auto files = draw_diagnosis(found, "rig", folder.path());
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].filename(), "errors-by-horizon.svg");
  const std::string errors = read_bytes(files[0]), ranking = read_bytes(files[1]);
  EXPECT_THAT(errors, HasSubstr("with the answer"));
  EXPECT_THAT(errors, Not(HasSubstr("held out")));
  EXPECT_THAT(ranking, HasSubstr("cross-validated gain over the three shortest horizons"));
}

TEST(DiagnosisPictures, ShowTheForceOfEachJointAndTheRanking) {
  const TestFolder folder;
  const auto files = draw_diagnosis(not_in_library(), "bench", folder.path());
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].filename(), "ranking.svg");
  const std::string ranking = read_bytes(files[0]);
  for (const char* words : {"not_in_library · probability 0.93", "viscous_friction @ joint.hinge"})
    EXPECT_THAT(ranking, HasSubstr(words));
  EXPECT_EQ(files[1].filename(), "residual-force-hinge.svg");
  const std::string hinge = read_bytes(files[1]);
  for (const char* words :
       {"-0.0105*v*abs(v) N·m", "position [rad]", "velocity [rad/s]", "command [N·m]", "at -0.80 rad", "at 0.80 rad"})
    EXPECT_THAT(hinge, HasSubstr(words));
  const std::string wrist = read_bytes(files[2]);
  EXPECT_THAT(wrist, HasSubstr("position [rad]"));
  EXPECT_THAT(wrist, Not(HasSubstr("abs(v)")));
  EXPECT_THAT(wrist, Not(HasSubstr("at 0.80 rad")));
}

TEST(DiagnosisPictures, ShowTheMissingForceWithThatOfTheAnswer) {
  const TestFolder folder;
  Diagnosis found;
  found.verdict = Verdict::effect_found;
  found.missing_force = {drag("hinge", "velocity", "rad/s")};
  found.missing_force.front().by_answer = found.missing_force.front().force;
  const auto files = draw_diagnosis(found, "rig", folder.path());
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].filename(), "missing-force-hinge.svg");
  const std::string picture = read_bytes(files[0]);
  for (const char* words : {"missing torque [N·m]", "missing torque, 95 % band", "answer", "velocity [rad/s]"})
    EXPECT_THAT(picture, HasSubstr(words));
}

TEST(DiagnosisPictures, ShowNothingWhereThereIsNothing) {
  const TestFolder folder;
  EXPECT_TRUE(draw_diagnosis(Diagnosis{}, "bench", folder.path()).empty());
}

}  // namespace
}  // namespace lacuna
