#include "bad_effect.h"

/// A second effect of a name that Lacuna's own plugins have.
LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, bad::Effect>("coulomb_friction"))
