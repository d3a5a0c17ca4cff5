#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hidden_effects::dirty {

/// What a case is to be, before anything is simulated. All that is random in it follows from `seed`.
struct DirtyPlan {
  std::string
      set;  ///< "dirty-tuning", "dirty-reporting", "dirty-quick", "dirty-values", "dirty-loops" or "dirty-withheld"
  int number = 0;  ///< within the set
  std::uint64_t seed = 0;
  std::string family;  ///< of `families()`
  int mains = 0;       ///< main effects: 0, 1 or 2
  bool gross = false;  ///< the main effect is a value of the robot file that is wrong by a factor, where one shows
  bool must_be_gross = false;      ///< a law does not stand in for it
  double strength = 0.0;           ///< wanted error of the owner's refitted base by the main effects, over the noise
  int small = 0;                   ///< how many small effects
  int misstated = 0;               ///< how many values of the robot file are off by 1 to 10 %
  double disturbance = 0.0;        ///< random forces, over what the drives exert, RMS
  bool states_controller = false;  ///< the experiment file has the law of the controller
  bool must_be_force = false;      ///< the main effect is a force that goes with something (goes_with.cpp)
  bool withheld = false;  ///< the program is asked without all effects that are like the main one (goes_with.cpp)

  std::string name() const;  ///< "dirty-quick-0042"
};

/// Names of the families of rigs, in the order in which the sets take turns.
const std::vector<std::string>& families();

bool is_dirty_set(const std::string& set);

/// All cases of a set: 300 for tuning, 300 for reporting, 60 of `dirty-quick`, 40 of `dirty-values`, in which a value
/// of the robot file is wrong and nothing else, 30 of `dirty-loops`: under a controller outside of the drives, whose
/// commands answer random forces, with one main effect or none, and nothing else; 80 of `dirty-withheld`: one main
/// effect that is a force, and nothing else, half of them under random forces; in every second one the library is not
/// to have it. Families take turns; how many main
/// effects there are is balanced over the set. Throws `std::invalid_argument` for another name.
std::vector<DirtyPlan> plan_dirty_cases(const std::string& set);

}  // namespace hidden_effects::dirty
