#include "bad_effect.h"

/// Sound, but built with _GLIBCXX_DEBUG, under which std::vector has another size.
LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, bad::Effect>("other_layout"))
