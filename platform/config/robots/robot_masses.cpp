#include "config/robots/robot_masses.h"

#include "config/robots/mass_properties.h"

#include <cmath>

namespace lacuna {
namespace {

/// Resolves one body; `path` is its key.
class BodyResolver {
 public:
  BodyResolver(const BodyInFile& body, const Locations& locations, Reading& reading)
      : body_(body), locations_(locations), reading_(reading), path_("body." + body.spec.name) {}

  BodySpec resolve() {
    BodySpec spec = body_.spec;
    for (std::size_t i = 0; i < body_.shapes.size(); ++i) shapes_.push_back(resolve_shape(i));
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (body_.shapes[i].collides) spec.shapes.push_back(shapes_[i]);
    if (!reading_.is_troubled(path_)) resolve_mass(spec);
    if (body_.inertia) check_inertia(*body_.inertia);
    return spec;
  }

 private:
  void problem(const std::string& key, const std::string& message) {
    const std::string full = key.empty() ? path_ : path_ + "." + key;
    reading_.problem_at(full, nearest_location(locations_, full, ""), message);
  }

  /// Asks for a key that a kind of shape needs, refuses it where it means nothing.
  template <class T>
  void expect(bool needed, const std::optional<T>& value, const std::string& shape, const std::string& key) {
    if (needed && !value) problem(shape + "." + key, "is missing: this kind of shape needs it");
    if (!needed && value) problem(shape + "." + key, "is not used by this kind of shape; leave it out");
  }

  ShapeSpec resolve_shape(std::size_t index) {
    const ShapeInFile& written = body_.shapes[index];
    const std::string name = "shapes[" + std::to_string(index) + "]";
    ShapeSpec shape = written.spec;
    const bool is_box = shape.kind == ShapeKind::box;
    const bool has_length = shape.kind == ShapeKind::capsule || shape.kind == ShapeKind::cylinder;
    expect(is_box, written.size, name, "size");
    expect(!is_box, written.radius, name, "radius");
    expect(has_length, written.length, name, "length");
    shape.size =
        written.size.value_or(Eigen::Vector3d(written.radius.value_or(0.0), written.length.value_or(0.0), 0.0));
    if (written.along && written.rpy) problem(name, "has both along and rpy; keep one of them");
    if (written.along) shape.orientation = orientation_along(*written.along);
    if (written.rpy) shape.orientation = orientation_from_rpy(*written.rpy);
    if (written.mass && written.density) problem(name, "has both mass and density; keep one of them");
    return shape;
  }

  bool has_own_mass(std::size_t i) const { return body_.shapes[i].mass || body_.shapes[i].density; }

  /// The solids that the shapes stand for, or nothing where no mass is known of one of them.
  std::vector<MassProperties> solids() {
    double total_volume = 0.0;
    for (const ShapeSpec& shape : shapes_) total_volume += volume(shape);
    std::vector<MassProperties> parts;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const ShapeInFile& written = body_.shapes[i];
      const double density = written.density.value_or(body_.mass.value_or(0.0) / total_volume);
      parts.push_back(solid(shapes_[i], written.mass.value_or(density * volume(shapes_[i]))));
    }
    return parts;
  }

  void resolve_mass(BodySpec& spec) {
    std::size_t with_mass = 0;
    for (std::size_t i = 0; i < shapes_.size(); ++i) with_mass += has_own_mass(i) ? 1 : 0;
    const bool from_shapes = with_mass > 0 || (body_.mass && !body_.inertia && !shapes_.empty());
    if (with_mass > 0 && with_mass < shapes_.size())
      return problem("shapes", "some have a mass or density and some do not");
    if (with_mass > 0 && body_.mass) return problem("mass", "the shapes have masses too; keep one of them");
    if (!from_shapes && !body_.mass)
      return problem("mass", "is missing: a number in kg, or shapes with a mass or density");
    if (!from_shapes && !body_.inertia)
      return problem("inertia", "is missing: three moments in kg*m^2, or shapes from which it follows");
    if (body_.com && !body_.inertia)
      return problem(
          "com", "give inertia too, because the inertia of the shapes is about their centre of mass and not about com");
    if (!shapes_.empty()) take_shapes(spec);
    spec.mass = body_.mass.value_or(spec.mass);
    spec.com = body_.com.value_or(spec.com);
    spec.inertia = body_.inertia.value_or(spec.inertia);
  }

  void take_shapes(BodySpec& spec) {
    const MassProperties whole = joined(solids());
    spec.mass = whole.mass;
    spec.com = whole.com;
    spec.inertia = to_spec(whole.inertia);
    const bool usable = std::isnormal(whole.mass) && whole.com.allFinite() && inertia_objection(spec.inertia).empty();
    if (!usable) problem("shapes", "these shapes give no usable mass; check their sizes and densities");
  }

  void check_inertia(const InertiaSpec& inertia) {
    const std::string objection = inertia_objection(inertia);
    if (!objection.empty()) problem("inertia", objection);
  }

  const BodyInFile& body_;
  const Locations& locations_;
  Reading& reading_;
  std::string path_;
  std::vector<ShapeSpec> shapes_;
};

}  // namespace

BodySpec resolve_body(const BodyInFile& body, const Locations& locations, Reading& reading) {
  return BodyResolver(body, locations, reading).resolve();
}

}  // namespace lacuna
