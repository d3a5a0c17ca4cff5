#pragma once

#include <lacuna/physical_effect.h>

#include <string>

namespace lacuna {

/// The component `name` of the plugin library that holds the test-only effects.
const PhysicalEffect& test_effect(const std::string& name);

}  // namespace lacuna
