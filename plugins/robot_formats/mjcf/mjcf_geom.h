#pragma once

#include "mjcf_settings.h"

#include <optional>

namespace lacuna::mjcf {

/// The mass of a geom, in its body's frame: as stated, or its density (1000 kg/m³ by default) times its volume. Nothing
/// for planes, height fields and meshes, which are not read; a mesh with a stated mass counts as a ball.
std::optional<robot_files::RigidMass> mass_of_geom(const Attributes& geom, const Settings& settings);

/// Whether it is a mesh, or another shape in a separate file.
bool is_mesh(const Attributes& geom);

}  // namespace lacuna::mjcf
