#include "mjcf_sensors.h"

#include <set>

namespace lacuna::mjcf {
namespace {

constexpr double kSamePlace = 1e-9;  ///< m, or of a rotation

bool is_identity(const Eigen::Quaterniond& turn) { return turn.vec().norm() < kSamePlace; }

class SensorReader {
 public:
  SensorReader(const std::vector<Carried>& carried, File& file) : carried_(carried), file_(file) {}

  std::optional<SensorSpec> read(const XmlElement& element) {
    const std::string_view kind = element.name();
    SensorSpec spec;
    bool taken = false;
    if (kind == "jointpos")
      taken = of_joint(element, SensorKind::joint_position, spec);
    else if (kind == "jointvel")
      taken = of_joint(element, SensorKind::joint_velocity, spec);
    else if (kind == "jointactuatorfrc")
      taken = of_joint(element, SensorKind::drive_force, spec);
    else if (kind == "framepos")
      taken = of_body(element, SensorKind::body_position, spec);
    else if (kind == "framequat")
      taken = of_body(element, SensorKind::body_orientation, spec);
    else if (kind == "framelinvel")
      taken = of_body(element, SensorKind::body_velocity, spec);
    else if (kind == "frameangvel")
      taken = of_body(element, SensorKind::body_angular_velocity, spec);
    else if (kind == "accelerometer")
      taken = accelerometer(element, spec);
    if (!taken) {
      left_out_.insert(std::string(kind));
      return std::nullopt;
    }
    const std::string written = element.text_of("name").value_or("");
    spec.name = written.empty() ? file_.names.new_name("sensor", spec.element + "_" + std::string(kind))
                                : file_.names.named("sensor", written, element.line(), element.file(), file_.remarks);
    return spec;
  }

  const std::set<std::string>& left_out() const { return left_out_; }

 private:
  bool of_joint(const XmlElement& element, SensorKind kind, SensorSpec& spec) {
    const std::string written = element.required_text("joint");
    const auto found = file_.joint_of_name.find(written);
    if (found == file_.joint_of_name.end()) {
      element.problem("a sensor names the joint \"" + written + "\", which does not exist");
      return false;
    }
    const Joint& joint = file_.bodies[found->second.first].joints[found->second.second];
    if (joint.kind != JointKind::hinge && joint.kind != JointKind::slider) return false;
    spec.kind = kind;
    spec.element = joint.name;
    if (kind == SensorKind::joint_position) spec.offset = joint.reference;
    return true;
  }

  /// For the frame of a body that moves, not of one that is a part of another.
  bool of_body(const XmlElement& element, SensorKind kind, SensorSpec& spec) {
    if (element.text_of("objtype").value_or("") != "xbody" || element.text_of("reftype")) return false;
    const auto found = file_.body_of_name.find(element.required_text("objname"));
    if (found == file_.body_of_name.end()) return false;
    const Carried& carried = carried_[found->second];
    if (carried.body == kWorld || carried.pose.position.norm() > kSamePlace || !is_identity(carried.pose.orientation))
      return false;
    spec.kind = kind;
    spec.element = carried.body;
    return true;
  }

  bool accelerometer(const XmlElement& element, SensorSpec& spec) {
    const auto found = file_.sites.find(element.required_text("site"));
    if (found == file_.sites.end()) return false;
    const Carried& carried = carried_[found->second.body];
    const Pose pose = carried.pose * found->second.pose;
    if (carried.body == kWorld || !is_identity(pose.orientation)) return false;
    spec.kind = SensorKind::accelerometer;
    spec.element = carried.body;
    spec.at = pose.position;
    return true;
  }

  const std::vector<Carried>& carried_;
  File& file_;
  std::set<std::string> left_out_;
};

}  // namespace

std::vector<SensorSpec> read_sensors(const Document& document, const std::vector<Carried>& carried, File& file) {
  std::vector<SensorSpec> sensors;
  SensorReader reader(carried, file);
  const std::vector<XmlElement> elements = document.sections("sensor");
  for (const XmlElement& element : elements)
    if (std::optional<SensorSpec> spec = reader.read(element)) sensors.push_back(std::move(*spec));
  if (reader.left_out().empty()) return sensors;
  std::string kinds;
  for (const std::string& kind : reader.left_out()) kinds += (kinds.empty() ? "" : ", ") + kind;
  file.remark(RobotRemarkKind::left_out, elements.front(), "sensors of these kinds: " + kinds);
  return sensors;
}

}  // namespace lacuna::mjcf
