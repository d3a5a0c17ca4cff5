#pragma once

#include "dirty/dirty_plan.h"
#include "dirty/robot_value.h"
#include "plant/draw.h"
#include "plant/motion.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hidden_effects::dirty {

/// How the joints of a rig come to move.
enum class Driving {
  none,           ///< it is let go
  open_loop,      ///< forces or voltages from a list
  servo,          ///< goals of position servos, which close their loops themselves
  position_loop,  ///< a controller outside makes the forces, from the readings of positions
  velocity_loop,  ///< the same, from their rate of change
  imposed         ///< a bench moves the joint and reads the force
};

/// The law of a controller outside of the drives, at each sample. SI, of one drive.
struct Loop {
  double proportional = 0.0;                               ///< force per position, of a velocity loop per velocity
  double derivative = 0.0;                                 ///< force per velocity
  double integral = 0.0;                                   ///< of the controlled quantity
  double limit = std::numeric_limits<double>::infinity();  ///< N·m or N
};

/// A trial before it is carried out.
struct TrialPlan {
  std::string name;
  bool held_out = false;
  std::size_t samples = 0;
  Start start;
  std::vector<std::vector<double>> reference;  ///< by drive, one a sample: force, voltage, goal or imposed position
};

/// A value that the owner fits.
struct OwnerFree {
  RobotValue value;
  double spread = 0.15;             ///< share by which the truth may differ from the robot file
  double lower = 0.2, upper = 5.0;  ///< bounds, times the robot file's value
};

/// A rig as its owner describes it, and how it is moved.
struct DirtyRig {
  std::string family;
  PlantSpec stated;               ///< the robot file
  std::vector<OwnerFree> free;    ///< fitted by the owner
  std::vector<RobotValue> fixed;  ///< stated and not fitted: may be wrong
  Driving driving = Driving::none;
  std::vector<Loop> loops;  ///< by drive
  double rate = 1.0;        ///< rad/s, the natural frequency or 1 over the time scale
  double fastest = 1.0;     ///< rad/s, of what has to be integrated
  double interval = 0.01;   ///< s, between samples
  double longest = 1.0;     ///< s, over which the base's prediction means something
  double force = 0.0;       ///< N·m or N, of the forces at work where the motion does not show them; 0: it does
  double noise = 1e-3;      ///< of positions, over the range of their motion
  std::vector<TrialPlan> trials;
};

/// Random numbers of the kinds that rigs are drawn from.
class RigDraw : public Draw {
 public:
  using Draw::Draw;
  double log_between(double lower, double upper) { return lower * std::pow(upper / lower, uniform()); }
  bool chance(double share) { return uniform() < share; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
};

/// The rig of a case, from its seed alone.
DirtyRig draw_rig(const DirtyPlan& plan);

/// kg, of all bodies.
double mass_of(const DirtyRig& rig);

/// The builders of families; each draws masses, lengths, rates, trials and what its owner frees.
DirtyRig free_pendulum(RigDraw& draw);
DirtyRig driven_pendulum(RigDraw& draw);
DirtyRig upright_pendulum(RigDraw& draw);
DirtyRig spring_oscillator(RigDraw& draw);
DirtyRig driven_slider(RigDraw& draw);
DirtyRig falling_body(RigDraw& draw);
DirtyRig wheel_running_down(RigDraw& draw);
DirtyRig voltage_motor(RigDraw& draw);
DirtyRig imposed_motion(RigDraw& draw);
DirtyRig position_servo(RigDraw& draw);
DirtyRig controlled_axis(RigDraw& draw);
DirtyRig velocity_axis(RigDraw& draw);
DirtyRig two_link_arm(RigDraw& draw);
DirtyRig three_link_arm(RigDraw& draw);
DirtyRig six_joint_arm(RigDraw& draw);

}  // namespace hidden_effects::dirty
