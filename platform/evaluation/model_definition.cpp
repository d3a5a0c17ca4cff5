#include "evaluation/model_definition.h"

namespace lacuna {

ModelDefinition define_model(const Experiment&, const PluginCatalog&) { return {}; }

}  // namespace lacuna
