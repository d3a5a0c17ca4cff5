#pragma once

#include "formula/force_law.h"

#include <string>

namespace lacuna {

/// The files of a plugin with one effect, a force law on a joint. It builds as a separate project with the installed
/// package, and as a folder of plugins/effects. Smooth terms are differentiated at run time (lacuna/dual.h) and
/// integrated implicitly where they damp or hold; terms with sgn(v) become dry friction. A law with the command u is
/// placed on actuators, the others on joints.

/// `NAME.cpp`.
std::string effect_source(const std::string& name, const ForceLaw& law);
/// `CMakeLists.txt`; in a separate project `ctest` runs `lacuna plugins check`.
std::string effect_project(const std::string& name);
/// `README.md`, with the table of parameters and a snippet that runs.
std::string effect_readme(const std::string& name, const ForceLaw& law);

/// water_drag as WaterDrag.
std::string camel_case(const std::string& name);

/// Replaces each @WORD@ of a text by its value in `with`.
std::string filled(std::string text, const std::map<std::string, std::string>& with);

}  // namespace lacuna
