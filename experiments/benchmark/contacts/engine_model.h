#pragma once

#include "contacts/contact_rig.h"

#include <filesystem>
#include <memory>

namespace hidden_effects {

/// How a rig is put into the engine.
enum class Integration {
  owner,  ///< as its owner does
  truth,  ///< at a tenth of the owner's step, on the real ground
};

/// A rig in the engine of the program, one value free.
class EngineModel {
 public:
  /// `folder` holds the rig's robot.toml. Laws must have the library's form. Throws `lacuna::Error`.
  EngineModel(const ContactRig& rig, const std::filesystem::path& folder, Integration integration,
              const std::vector<SizedContactLaw>& laws);
  ~EngineModel();

  /// What its sensors read without noise, by channel of the rig. `commands`: by drive, evenly spaced by
  /// `command_interval` s and held. Throws `std::runtime_error` where the simulation fails.
  Samples readings(double free_value, const Samples& commands, double command_interval) const;

 private:
  struct Compiled;
  const ContactRig& rig_;
  std::unique_ptr<Compiled> compiled_;
};

/// The tables [model] to [engine.contact] of an experiment file.
std::string model_text(const ContactRig& rig, Integration integration, const std::vector<SizedContactLaw>& laws);

}  // namespace hidden_effects
