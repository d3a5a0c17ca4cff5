#include "dirty/dirty_rig.h"

#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

struct Family {
  const char* name;
  DirtyRig (*draw)(RigDraw&);
};

constexpr Family kFamilies[] = {{"free_pendulum", free_pendulum},       {"driven_slider", driven_slider},
                                {"controlled_axis", controlled_axis},   {"falling_body", falling_body},
                                {"two_link_arm", two_link_arm},         {"imposed_motion", imposed_motion},
                                {"position_servo", position_servo},     {"wheel_running_down", wheel_running_down},
                                {"driven_pendulum", driven_pendulum},   {"six_joint_arm", six_joint_arm},
                                {"velocity_axis", velocity_axis},       {"spring_oscillator", spring_oscillator},
                                {"upright_pendulum", upright_pendulum}, {"voltage_motor", voltage_motor},
                                {"three_link_arm", three_link_arm}};

}  // namespace

const std::vector<std::string>& families() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Family& family : kFamilies) all.emplace_back(family.name);
    return all;
  }();
  return names;
}

DirtyRig draw_rig(const DirtyPlan& plan) {
  for (const Family& family : kFamilies) {
    if (plan.family != family.name) continue;
    RigDraw draw(plan.seed, 2);
    DirtyRig rig = family.draw(draw);
    rig.family = plan.family;
    return rig;
  }
  throw std::invalid_argument("no family is called " + plan.family);
}

double mass_of(const DirtyRig& rig) {
  double sum = 0.0;
  for (const PlantBody& body : rig.stated.bodies) sum += body.mass;
  return sum;
}

}  // namespace hidden_effects::dirty
