#pragma once

#include "mjcf_settings.h"

#include <optional>

namespace lacuna::mjcf {

/// What a geom weighs, in its body's frame: its mass, or its density (1000 kg/m³ by default) over its volume. Nothing
/// of planes, height fields and meshes, which are not read; a mesh that says its mass counts as a ball.
std::optional<robot_files::RigidMass> mass_of_geom(const Attributes& geom, const Settings& settings);

/// Whether it is a mesh, or another shape that stands in a file of its own.
bool is_mesh(const Attributes& geom);

}  // namespace lacuna::mjcf
