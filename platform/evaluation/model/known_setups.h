#pragma once

#include "evaluation/model/model_definition.h"
#include "foundation/recording_source.h"
#include <string>
#include <vector>

namespace lacuna {

struct ModelDefinition;
struct RecordingSource;

/// A setup of recordings that the rig can have again: its set values, and the values fitted to it alone.
struct KnownSetup {
  struct Setting {
    std::string address;
    double value = 0.0;  ///< SI
    std::string unit;
    bool operator==(const Setting&) const = default;
  };
  std::vector<std::string> names = {""};     ///< of recordings with the same set values; "": none, the model's values
  std::vector<Setting> settings = {};        ///< by address
  std::vector<std::string> own = {};         ///< addresses of values that are unknown and fitted to this setup alone
  std::vector<std::string> recordings = {};  ///< their files, without folders

  /// The setup as a test names it.
  const std::string& name() const { return names.front(); }
  bool operator==(const KnownSetup&) const = default;
};

/// The setups of the recordings, each once, in the order of the file; the first is the default of a test. Recordings
/// with the same set values and without their own unknown values share one. The model as it is, without a setup, is in
/// the list if a recording has none, or if there is no recording.
std::vector<KnownSetup> known_setups(const ModelDefinition& definition, const RecordingSource& source);

/// Whether any recording has a setup; otherwise messages do not mention setups.
bool any_is_set(const std::vector<KnownSetup>& setups);

/// The word to type for it: its name, or "none".
std::string setup_to_type(const KnownSetup& setup);
/// The setup of that name, or "none" for the model as it is. Throws `BadInput` with a list of the known ones.
const KnownSetup& find_setup(const std::vector<KnownSetup>& setups, const std::string& name);

/// "body.load.mass = 0.49 kg, sensor.angle.offset fitted to it alone"; without a setup "values of the model".
std::string settings_text(const KnownSetup& setup);
/// "setup heavy (body.load.mass = 0.49 kg)", or "no setup (values of the model)".
std::string setup_text(const KnownSetup& setup);

}  // namespace lacuna
