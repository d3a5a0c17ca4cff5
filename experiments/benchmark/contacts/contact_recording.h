#pragma once

#include "cases/case_plan.h"
#include "contacts/engine_model.h"

#include <optional>

namespace hidden_effects {

/// A trial as it was recorded.
struct ContactTrial {
  std::string name;
  bool held_out = false;
  Samples commands;  ///< by drive
  Samples readings;  ///< by channel
};

/// A real robot with its recorder: `seed` decides the commands and all noise. The hopper is integrated apart from the
/// engine; the others are the engine at a tenth of the owner's step on a ground that is not quite the owner's.
///
/// Noise: white on the sensors; then half of it, slow noise beside it and coarse encoders; then also noise on the
/// recorded commands and a random force on each driven joint, which the engine gets as a change of the command that
/// amounts to it. Touch sensors have none.
class ContactBench {
 public:
  /// `folder` holds the rig's robot.toml. The rig must outlive the bench.
  ContactBench(const ContactRig& rig, const std::filesystem::path& folder, std::vector<SizedContactLaw> laws,
               double free_value, NoiseLevel noise, std::uint64_t seed);

  /// The trial of that number, the same whatever was recorded before.
  ContactTrial record(int number) const;

 private:
  Samples true_readings(const Samples& applied, double interval) const;

  const ContactRig& rig_;
  std::vector<SizedContactLaw> laws_;
  double free_value_;
  NoiseLevel noise_;
  std::uint64_t seed_;
  std::optional<EngineModel> engine_;  ///< none of the hopper
};

/// What a channel that is right may be off by, SI.
double deviation(const ContactChannel& channel, NoiseLevel noise);

}  // namespace hidden_effects
