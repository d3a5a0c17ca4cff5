#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hidden_effects {

enum class NoiseLevel {
  white,      ///< white noise on the sensors
  coloured,   ///< slow noise on the sensors, and coarse encoders
  disturbed,  ///< the same, an unmodelled random force on each joint, and noise on the recorded command
};
std::string_view to_string(NoiseLevel level);

/// A law of `all_laws` that a case hides, and on which joint, body, drive or sensor (0 for the world).
/// Of a contact case: a law of its rig, and which of them.
struct HiddenLaw {
  std::string law;
  int element = 0;
};

/// What a case is to be. Everything random in it follows from `seed`.
struct CasePlan {
  std::string set;    ///< "tuning", "reporting" or "fixed"
  int number = 0;     ///< within the set
  std::string group;  ///< "one_joint", "two_joint", "contact", "nothing", "two_effects" or "withheld"
  std::string rig;
  std::vector<HiddenLaw> hidden;
  double strength =
      1.0;  ///< wanted: RMSE of the refitted base over that of the refitted truth; 1 where nothing is hidden
  NoiseLevel noise = NoiseLevel::white;
  double duration = 5.0;  ///< s, of each trial
  std::uint64_t seed = 0;
  std::vector<std::string> known;  ///< addresses of values that this case's user does not free

  std::string name() const;  ///< "reporting-0042"
};

/// The sets without contacts: 1 400 cases for reporting, 142 for tuning, 40 short ones with one joint for the tests.
/// Effects, rigs, strengths and noise are balanced by turns, in an order that the set's seed shuffles.
std::vector<CasePlan> plan_cases(const std::string& set);

}  // namespace hidden_effects
