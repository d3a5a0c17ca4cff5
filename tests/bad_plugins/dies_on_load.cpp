#include "bad_effect.h"

#include <csignal>

namespace {

/// Static initialisers run before anybody can look at the table.
struct Fatal {
  Fatal() { std::raise(SIGSEGV); }
};
const Fatal fatal;

}  // namespace

LACUNA_PLUGIN(lacuna::component<lacuna::PhysicalEffect, bad::Effect>("dies_on_load"))
