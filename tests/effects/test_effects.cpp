#include "effects/test_effects.h"

#include "loading/plugin_catalog.h"

namespace lacuna {

const PhysicalEffect& test_effect(const std::string& name) {
  static const PluginCatalog catalog({LACUNA_TEST_EFFECTS_DIRECTORY});
  return catalog.get<PhysicalEffect>(name);
}

}  // namespace lacuna
