#include "urdf_file.h"

#include "xml_element.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace lacuna::urdf {
namespace {

using robot_files::XmlElement;

/// Whether it is a template with elements of xacro instead of a robot. Comments do not count.
bool is_xacro(const tinyxml2::XMLElement& element) {
  if (std::string_view(element.Name()).starts_with("xacro:")) return true;
  for (const tinyxml2::XMLElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
    if (is_xacro(*child)) return true;
  return false;
}

bool is_of_names(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

Eigen::Quaterniond turned(const Eigen::Vector3d& rpy) {
  return Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
}

Pose pose_of(const XmlElement& parent) {
  const std::optional<XmlElement> origin = parent.child("origin");
  if (!origin) return {};
  return {origin->vector("xyz", Eigen::Vector3d::Zero()), turned(origin->vector("rpy", Eigen::Vector3d::Zero()))};
}

/// Reads the elements below <robot>.
class FileReader {
 public:
  explicit FileReader(File& file) : file_(file) {}

  void read(const tinyxml2::XMLElement& root, RobotBase base) {
    const XmlElement robot(root, file_.problems);
    file_.name = named(robot.text_of("name").value_or("robot"), robot.line());
    for (const XmlElement& link : robot.children("link")) read_link(link);
    for (const XmlElement& joint : robot.children("joint")) read_joint(joint);
    take_commands(robot);
    if (base == RobotBase::free || hangs_on_a_joint(kWorld)) tell_from_world();
    for (const XmlElement& one : robot.children()) note_unread(one);
    for (const auto& [name, line] : unread_)
      remark(RobotRemarkKind::left_out, line, "<" + name + "> has no equivalent in a model");
    if (file_.links.empty()) robot.problem("has no <link>; a robot needs at least one");
  }

 private:
  void remark(RobotRemarkKind kind, int line, std::string text) {
    file_.remarks.push_back({kind, line, std::move(text)});
  }

  /// Equal names get equal names.
  std::string named(const std::string& written, int line) {
    std::string name = written;
    for (char& c : name)
      if (!is_of_names(c)) c = '_';
    if (name != written && written_.insert(written).second)
      remark(RobotRemarkKind::repaired, line,
             "\"" + written + "\" gets the name " + name + ": names have letters, digits, _ and - only");
    return name;
  }

  void read_link(const XmlElement& element) {
    Link link{named(element.required_text("name"), element.line()), element.line(), {}, 0};
    link.collisions = element.children("collision").size();
    if (const std::optional<XmlElement> inertial = element.child("inertial")) link.mass = mass_of(*inertial);
    if (!links_.insert(link.name).second) element.problem("there are two links \"" + link.name + "\"; rename one");
    file_.links.push_back(std::move(link));
  }

  static RigidMass mass_of(const XmlElement& inertial) {
    const Pose pose = pose_of(inertial);
    RigidMass mass{0.0, pose.position, Eigen::Matrix3d::Zero()};
    if (const std::optional<XmlElement> value = inertial.child("mass"))
      mass.mass = value->required_number("value");
    else
      inertial.problem("inertial's <mass value=\"...\"/> is missing");
    if (mass.mass < 0.0) inertial.problem("the mass is negative; it must be above 0 kg");
    const std::optional<XmlElement> inertia = inertial.child("inertia");
    if (!inertia) return mass;
    Eigen::Matrix3d own;
    const double xy = inertia->number("ixy", 0.0), xz = inertia->number("ixz", 0.0), yz = inertia->number("iyz", 0.0);
    own << inertia->required_number("ixx"), xy, xz, xy, inertia->required_number("iyy"), yz, xz, yz,
        inertia->required_number("izz");
    const Eigen::Matrix3d turn = pose.orientation.toRotationMatrix();
    mass.inertia = turn * own * turn.transpose();
    return mass;
  }

  void read_joint(const XmlElement& element) {
    Joint joint;
    joint.name = named(element.required_text("name"), element.line());
    joint.line = element.line();
    joint.type = type_of(element);
    joint.parent = link_of(element, "parent");
    joint.child = link_of(element, "child");
    joint.origin = pose_of(element);
    if (!joints_.insert(joint.name).second) element.problem("there are two joints \"" + joint.name + "\"; rename one");
    if (joint.type != JointType::fixed) read_motion(element, joint);
    file_.joints.push_back(std::move(joint));
  }

  static JointType type_of(const XmlElement& element) {
    static const std::map<std::string, JointType> kTypes = {
        {"revolute", JointType::revolute}, {"continuous", JointType::continuous}, {"prismatic", JointType::prismatic},
        {"fixed", JointType::fixed},       {"floating", JointType::floating},     {"planar", JointType::planar}};
    const std::string type = element.required_text("type");
    const auto found = kTypes.find(type);
    if (found != kTypes.end()) return found->second;
    element.problem("joint's type \"" + type +
                    "\" is unknown; known are revolute, continuous, prismatic, fixed, floating and planar");
    return JointType::fixed;
  }

  std::string link_of(const XmlElement& joint, const char* which) {
    const std::optional<XmlElement> element = joint.child(which);
    if (element) return named(element->required_text("link"), element->line());
    joint.problem(std::string("joint's <") + which + " link=\"...\"/> is missing");
    return {};
  }

  void read_motion(const XmlElement& element, Joint& joint) {
    if (const std::optional<XmlElement> axis = element.child("axis"))
      joint.axis = axis->vector("xyz", Eigen::Vector3d::UnitX());
    if (joint.axis.stableNorm() > 0.0)
      joint.axis.stableNormalize();
    else
      element.problem("axis \"0 0 0\" has no direction");
    if (const std::optional<XmlElement> dynamics = element.child("dynamics")) {
      joint.damping = dynamics->number("damping", 0.0);
      joint.friction = dynamics->number("friction", 0.0);
      if (joint.damping < 0.0 || joint.friction < 0.0) dynamics->problem("damping and friction must be 0 or above");
    }
    if (const std::optional<XmlElement> limit = element.child("limit")) read_limit(*limit, joint);
    if (const std::optional<XmlElement> mimic = element.child("mimic"))
      joint.mimic = Mimic{named(mimic->required_text("joint"), mimic->line()), mimic->number("multiplier", 1.0),
                          mimic->number("offset", 0.0)};
  }

  void read_limit(const XmlElement& limit, Joint& joint) {
    joint.effort = limit.number("effort", 0.0);
    joint.velocity = limit.number("velocity", 0.0);
    if (joint.type == JointType::continuous) return;
    const double lower = limit.number("lower", 0.0), upper = limit.number("upper", 0.0);
    if (lower > upper) return limit.problem("limit's lower is above its upper; exchange them");
    if (lower == upper) {
      remark(RobotRemarkKind::guessed, limit.line(), "joint " + joint.name + " has no range; it gets no stops");
      return;
    }
    joint.lower = lower;
    joint.upper = upper;
  }

  void take_commands(const XmlElement& robot) {
    std::map<std::string, Joint*> joints;
    for (Joint& joint : file_.joints) joints[joint.name] = &joint;
    for (auto& [written, commands] : read_commands(robot)) {
      const auto found = joints.find(named(written, commands.line));
      if (found == joints.end()) {
        remark(RobotRemarkKind::left_out, commands.line,
               "commands of \"" + written + "\", which is not a joint of the robot");
        continue;
      }
      file_.says_commands = file_.says_commands || !commands.interfaces.empty();
      found->second->commands = commands;
    }
  }

  bool hangs_on_a_joint(const std::string& link) const {
    return std::any_of(file_.joints.begin(), file_.joints.end(), [&](const Joint& one) { return one.child == link; });
  }

  /// A link named world is fixed; a moving link of that name gets another name.
  void tell_from_world() {
    if (!links_.contains(kWorld)) return;
    std::string name = "world_body";
    while (links_.contains(name)) name += '_';
    for (Link& link : file_.links)
      if (link.name == kWorld) {
        link.name = name;
        remark(RobotRemarkKind::repaired, link.line, "link world moves and gets the name " + name);
      }
    for (Joint& joint : file_.joints)
      for (std::string* link : {&joint.parent, &joint.child})
        if (*link == kWorld) *link = name;
  }

  /// One remark per kind of element.
  void note_unread(const XmlElement& element) {
    static const std::set<std::string, std::less<>> kRead = {"link", "joint", "material", "ros2_control",
                                                             "transmission"};
    if (!kRead.contains(element.name())) unread_.try_emplace(std::string(element.name()), element.line());
  }

  File& file_;
  std::set<std::string> links_, joints_, written_;
  std::map<std::string, int> unread_;  ///< by name, with its first place
};

}  // namespace

File read_file(const std::string& text, RobotBase base) {
  File file;
  tinyxml2::XMLDocument document;
  const std::string readable = robot_files::without_late_declarations(text);
  document.Parse(readable.data(), readable.size());
  if (document.Error()) {
    file.problems.push_back({document.ErrorLineNum(), std::string("is not a complete XML document (") +
                                                          document.ErrorName() +
                                                          "); is it incomplete or in another format?"});
    return file;
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (const int line = robot_files::line_behind_root(document); line > 0)
    file.problems.push_back({line, "text follows the outermost element; remove it"});
  else if (root != nullptr && is_xacro(*root))
    file.problems.push_back({0, "is a xacro file, from which a URDF is made; make it with xacro FILE > robot.urdf"});
  else if (root == nullptr || std::string_view(root->Name()) != "robot")
    file.problems.push_back({root ? root->GetLineNum() : 0, "is not a URDF: its root is not <robot>"});
  else
    FileReader(file).read(*root, base);
  return file;
}

}  // namespace lacuna::urdf
