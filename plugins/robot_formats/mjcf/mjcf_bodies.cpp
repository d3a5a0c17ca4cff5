#include "mjcf_file.h"
#include "mjcf_geom.h"

#include "inertia_repair.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <set>

namespace lacuna::mjcf {
namespace {

using robot_files::RigidMass;

/// Context of an element: its body, a frame in that, and the class of its defaults.
struct Place {
  std::size_t body = 0;
  Pose frame;
  std::string childclass;
};

class BodyReader {
 public:
  BodyReader(const Document& document, const DefaultClasses& classes, File& file)
      : document_(document), classes_(classes), file_(file) {}

  void read() {
    Body world;
    world.name = kWorld;
    file_.bodies.push_back(std::move(world));
    geoms_.resize(1);
    for (const XmlElement& section : document_.sections())
      if (section.name() == "worldbody") read_inside(section, {0, {}, childclass_of(section, "")});
    for (std::size_t i = 1; i < file_.bodies.size(); ++i) weigh(i);
    scale_to_total();
  }

 private:
  std::string childclass_of(const XmlElement& element, const std::string& around) {
    const std::optional<std::string> own = element.text_of("childclass");
    if (own && !classes_.has(*own)) element.problem("there is no default class \"" + *own + "\"");
    return own.value_or(around);
  }

  void read_inside(const XmlElement& element, const Place& place) {
    for (const XmlElement& child : document_.children(element)) {
      const std::string_view name = child.name();
      if (name == "body")
        read_body(child, place);
      else if (name == "frame")
        read_inside(child,
                    {place.body, place.frame * pose_of(child, file_.settings), childclass_of(child, place.childclass)});
      else if (name == "geom")
        read_geom(child, place);
      else if (name == "site")
        read_site(child, place);
      else if (name == "joint" || name == "freejoint")
        add_joint(child, place);
      else if (name == "inertial")
        read_inertial(child, place);
      else
        note_unread(child);
    }
  }

  void read_body(const XmlElement& element, const Place& around) {
    Body body;
    const std::string written = element.text_of("name").value_or("");
    body.name = written.empty() ? file_.names.new_name("body", "body_" + std::to_string(file_.bodies.size()))
                                : file_.names.named("body", written, element.line(), element.file(), file_.remarks);
    body.line = element.line();
    body.file = element.file();
    body.parent = around.body;
    body.pose = around.frame * pose_of(element, file_.settings);
    const std::size_t index = file_.bodies.size();
    if (!written.empty() && !file_.body_of_name.emplace(written, index).second)
      element.problem("there are two bodies \"" + written + "\"; rename one");
    if (Attributes(element, {}).flag("mocap", false))
      file_.remark(RobotRemarkKind::left_out, element, "mocap body " + body.name + " does not move");
    if (element.number("gravcomp", 0.0) != 0.0)
      file_.remark(RobotRemarkKind::left_out, element, "the compensation of gravity of body " + body.name);
    file_.bodies.push_back(std::move(body));
    geoms_.emplace_back();
    read_inside(element, {index, {}, childclass_of(element, around.childclass)});
  }

  void read_geom(const XmlElement& element, const Place& place) {
    const Attributes geom = classes_.of(element, place.childclass);
    const bool is_asked = place.body != 0 && file_.settings.inertia_from_geom != InertiaFromGeom::never;
    if (is_mesh(geom)) {
      if (geom.number("mass", 1.0) != 0.0) ++file_.bodies[place.body].unread_meshes;
      note_once(element, "mesh", "meshes: their shapes are not read");
    }
    if (geom.number("contype", 1.0) != 0.0 || geom.number("conaffinity", 1.0) != 0.0)
      note_once(element, "contact", "collision shapes: the robot touches nothing");
    if (!is_asked) return;
    if (const std::optional<RigidMass> mass = mass_of_geom(geom, file_.settings))
      geoms_[place.body].push_back(moved(*mass, place.frame));
  }

  void read_site(const XmlElement& element, const Place& place) {
    const std::optional<std::string> name = element.text_of("name");
    if (name)
      file_.sites[*name] = {place.body, place.frame * pose_of(classes_.of(element, place.childclass), file_.settings)};
  }

  void add_joint(const XmlElement& element, const Place& place) {
    if (place.body == 0) return element.problem("the world has a joint; joints must be in bodies");
    Body& body = file_.bodies[place.body];
    Joint joint = read_joint(classes_.of(element, place.childclass), file_.settings, file_);
    joint.anchor = place.frame.position + place.frame.orientation * joint.anchor;
    joint.axis = place.frame.orientation * joint.axis;
    const std::string written = element.text_of("name").value_or("");
    joint.name = written.empty() ? file_.names.new_name("joint", body.name + "_joint")
                                 : file_.names.named("joint", written, element.line(), element.file(), file_.remarks);
    if (!written.empty() && !file_.joint_of_name.emplace(written, std::pair(place.body, body.joints.size())).second)
      element.problem("there are two joints \"" + written + "\"; rename one");
    if (joint.kind == JointKind::free && body.parent != 0)
      element.problem("body " + body.name + " floats but has a parent; only a body in the world can float");
    body.joints.push_back(std::move(joint));
    const bool any_free = std::any_of(body.joints.begin(), body.joints.end(),
                                      [](const Joint& one) { return one.kind == JointKind::free; });
    if (any_free && body.joints.size() > 1) element.problem("body " + body.name + " floats and has another joint");
  }

  void read_inertial(const XmlElement& element, const Place& place) {
    if (place.body == 0) return;
    const Pose pose = place.frame * pose_of(element, file_.settings);
    RigidMass mass{element.required_number("mass"), pose.position, Eigen::Matrix3d::Zero()};
    if (mass.mass < 0.0) element.problem("inertial's mass is negative");
    Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
    const auto full = element.numbers("fullinertia", 6, 6);
    const auto diagonal = element.numbers("diaginertia", 3, 3);
    if (full && diagonal) element.problem("inertial has diaginertia and fullinertia; keep one");
    if (full) {
      const std::vector<double>& f = *full;
      own << f[0], f[3], f[4], f[3], f[1], f[5], f[4], f[5], f[2];
    } else if (diagonal) {
      own.diagonal() << diagonal->at(0), diagonal->at(1), diagonal->at(2);
    }
    const Eigen::Matrix3d turn = pose.orientation.toRotationMatrix();
    mass.inertia = turn * own * turn.transpose();
    file_.bodies[place.body].mass = mass;
  }

  /// The values in the file, or those of its geoms, within the compiler's bounds.
  void weigh(std::size_t index) {
    Body& body = file_.bodies[index];
    const InertiaFromGeom from = file_.settings.inertia_from_geom;
    if (from == InertiaFromGeom::always || (from == InertiaFromGeom::where_missing && !body.mass)) {
      body.mass.reset();
      if (!geoms_[index].empty()) body.mass = joined(geoms_[index]);
    } else {
      body.unread_meshes = 0;
    }
    if (!body.mass) body.mass = RigidMass{};
    bound(*body.mass);
    if (body.mass->mass > 0.0 && !robot_files::can_be(body.mass->inertia)) repair(body);
    if (body.mass->mass == 0.0) body.mass.reset();
  }

  void bound(RigidMass& mass) const {
    mass.mass = std::max(mass.mass, file_.settings.least_mass);
    if (file_.settings.least_inertia <= 0.0) return;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(mass.inertia);
    if (solver.eigenvalues()(0) >= file_.settings.least_inertia) return;
    mass.inertia = solver.eigenvectors() * solver.eigenvalues().cwiseMax(file_.settings.least_inertia).asDiagonal() *
                   solver.eigenvectors().transpose();
  }

  void repair(Body& body) {
    if (file_.settings.balance_inertia && body.mass->inertia.trace() > 0.0)
      body.mass->inertia = body.mass->inertia.trace() / 3.0 * Eigen::Matrix3d::Identity();
    else
      body.mass->inertia = robot_files::repaired(body.mass->inertia, body.mass->mass);
    file_.remarks.push_back({RobotRemarkKind::repaired, body.line,
                             "the inertia of body " + body.name +
                                 " is impossible: a principal moment is not above 0, or above the sum of the others; " +
                                 (file_.settings.balance_inertia ? "their mean" : "the nearest possible one") +
                                 " is used",
                             body.file});
  }

  void scale_to_total() {
    if (!(file_.settings.total_mass > 0.0)) return;
    double total = 0.0;
    for (const Body& body : file_.bodies) total += body.mass ? body.mass->mass : 0.0;
    if (!(total > 0.0)) return;
    for (Body& body : file_.bodies)
      if (body.mass) {
        body.mass->mass *= file_.settings.total_mass / total;
        body.mass->inertia *= file_.settings.total_mass / total;
      }
  }

  void note_unread(const XmlElement& element) {
    static const std::set<std::string_view> kSilent = {"camera", "light", "plugin"};
    if (kSilent.contains(element.name())) return;
    note_once(element, std::string(element.name()), "<" + std::string(element.name()) + "> in a body: not read");
  }

  void note_once(const XmlElement& element, const std::string& what, const std::string& text) {
    if (noted_.insert(what).second) file_.remark(RobotRemarkKind::left_out, element, text);
  }

  const Document& document_;
  const DefaultClasses& classes_;
  File& file_;
  std::vector<std::vector<RigidMass>> geoms_;  ///< by body, in its frame
  std::set<std::string> noted_;
};

}  // namespace

void read_bodies(const Document& document, const DefaultClasses& classes, File& file) {
  BodyReader(document, classes, file).read();
}

}  // namespace lacuna::mjcf
