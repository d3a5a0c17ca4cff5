#pragma once

#include "dirty/dirty_kind.h"
#include "dirty/recording.h"
#include "dirty/true_trial.h"

#include <memory>
#include <string>
#include <vector>

namespace hidden_effects::dirty {

enum class Role {
  main,       ///< what is to be named
  small,      ///< a law that explains a hundredth to a tenth of what the main effects do
  misstated,  ///< a value of the robot file that is off by 1 to 10 %
  reading     ///< an error of a sensor, as small
};
const char* to_string(Role role);

/// One thing that is not as the owner believes: a law, or a value of the robot file.
struct DirtyEffect {
  Role role = Role::main;
  const DirtyKind* kind = nullptr;  ///< null: it is a value
  int element = 0;
  double size = 1.0;               ///< of the law
  Shape shape{};                   ///< of the law
  std::vector<double> parameters;  ///< of the law
  RobotValue value;
  double factor = 1.0;             ///< the truth over what the robot file states
  std::shared_ptr<const Law> law;  ///< shared: the truth and models hold it, too
  double share = 0.0;              ///< of the owner's error that it explains, see `make_dirty_case`

  std::string what(const PlantSpec& stated) const;    ///< "smooth_dry_friction", "value body.arm.mass"
  std::string place(const PlantSpec& stated) const;   ///< "joint.hinge"
  std::string effect(const PlantSpec& stated) const;  ///< the library's name, or that of the value
  bool library_form() const { return !kind || kind->law.library_form; }  ///< false: a law of another form
  std::vector<std::string> accepted(const PlantSpec& stated) const;
};

/// A case with its truth.
struct DirtyCase {
  DirtyPlan plan;
  DirtyRig rig;
  Truth truth;
  std::vector<DirtyEffect> effects;
  std::vector<double> noise;  ///< of all reading errors together, by sensor: rad, m, rad/s, ...
  double error = 0.0;         ///< of the owner's refitted base, over the noise
  Recording recording;
  std::vector<RecordedTrial> recorded;
};

/// Makes a case; the same from the same plan. The error E is that of `OwnerError`, without noise, by the true trials.
/// The share of an effect is 1 − E_i²/E², where E_i is the error of the base with effect i taken in at its true values
/// and its free values refitted; of a sensor's law, that of the base by readings without it. Shares add up to one where
/// effects do not interact; two that do for each other have shares that add up to more.
/// Throws `std::runtime_error` where no rig of the plan comes out as planned.
DirtyCase make_dirty_case(const DirtyPlan& plan);

}  // namespace hidden_effects::dirty
