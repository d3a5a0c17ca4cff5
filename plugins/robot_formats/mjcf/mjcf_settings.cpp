#include "mjcf_settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna::mjcf {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kNoDirection = 1e-12;
constexpr const char* kOrientations[] = {"quat", "axisangle", "euler", "xyaxes", "zaxis"};

bool flag_of(const XmlElement& element, const char* attribute, bool otherwise) {
  return Attributes(element, {}).flag(attribute, otherwise);
}

void read_compiler(const XmlElement& compiler, Settings& settings) {
  if (const auto angle = compiler.text_of("angle")) {
    if (*angle != "degree" && *angle != "radian") compiler.problem("compiler's angle must be degree or radian");
    settings.degrees = *angle == "degree";
  }
  if (const auto sequence = compiler.text_of("eulerseq")) {
    if (sequence->size() != 3 || sequence->find_first_not_of("xyzXYZ") != std::string::npos)
      compiler.problem("compiler's eulerseq \"" + *sequence + "\" must be three letters of x, y, z, X, Y, Z");
    else
      settings.euler_axes = *sequence;
  }
  if (const auto from = compiler.text_of("inertiafromgeom"); from && *from != "auto")
    settings.inertia_from_geom =
        flag_of(compiler, "inertiafromgeom", false) ? InertiaFromGeom::always : InertiaFromGeom::never;
  settings.balance_inertia = flag_of(compiler, "balanceinertia", settings.balance_inertia);
  settings.auto_limits = flag_of(compiler, "autolimits", settings.auto_limits);
  settings.least_mass = compiler.number("boundmass", settings.least_mass);
  settings.least_inertia = compiler.number("boundinertia", settings.least_inertia);
  settings.total_mass = compiler.number("settotalmass", settings.total_mass);
  if (const auto groups = compiler.numbers("inertiagrouprange", 2, 2)) {
    settings.first_group = static_cast<int>(std::clamp(groups->at(0), -1e6, 1e6));
    settings.last_group = static_cast<int>(std::clamp(groups->at(1), -1e6, 1e6));
  }
  if (compiler.text_of("coordinate").value_or("local") != "local")
    compiler.problem("compiler's coordinate is not local; convert the file with MuJoCo 2.3 or older first");
}

void read_option(const Document& document, const XmlElement& option, Settings& settings,
                 std::vector<RobotRemark>& remarks) {
  settings.gravity = option.vector("gravity", settings.gravity);
  for (const XmlElement& flags : document.children(option, "flag"))
    if (flags.text_of("gravity").value_or("enable") == "disable") settings.gravity.setZero();
  for (const char* medium : {"density", "viscosity"})
    if (option.number(medium, 0.0) != 0.0)
      remarks.push_back({RobotRemarkKind::left_out, option.line(),
                         std::string("the ") + medium + " of the medium: add linear_drag or quadratic_drag for it",
                         option.file()});
}

Vector3d axis_of(char letter) {
  switch (letter) {
    case 'x':
    case 'X': return Vector3d::UnitX();
    case 'y':
    case 'Y': return Vector3d::UnitY();
    default: return Vector3d::UnitZ();
  }
}

Quaterniond of_euler(const Vector3d& angles, const Settings& settings) {
  Quaterniond turn = Quaterniond::Identity();
  for (int i = 0; i < 3; ++i) {
    const char letter = settings.euler_axes[static_cast<std::size_t>(i)];
    const Quaterniond one(AngleAxisd(settings.angle(angles(i)), axis_of(letter)));
    turn = letter >= 'x' ? turn * one : one * turn;
  }
  return turn;
}

Quaterniond of_axes(const XmlElement& element, const std::vector<double>& axes) {
  Vector3d x(axes[0], axes[1], axes[2]), y(axes[3], axes[4], axes[5]);
  x.stableNormalize();
  y.stableNormalize();
  y -= x.dot(y) * x;
  if (!(x.norm() > 0.5) || y.norm() < kNoDirection) {
    element.problem("xyaxes has two parallel axes");
    return Quaterniond::Identity();
  }
  y.normalize();
  Eigen::Matrix3d frame;
  frame << x, y, x.cross(y);
  return Quaterniond(frame);
}

Quaterniond of_z(const XmlElement& element, const Vector3d& z) {
  if (z.stableNorm() < kNoDirection) {
    element.problem("zaxis has no direction");
    return Quaterniond::Identity();
  }
  const Vector3d along = z.stableNormalized(), across = Vector3d::UnitZ().cross(along);
  const Vector3d axis = across.norm() < kNoDirection ? Vector3d::UnitX() : Vector3d(across.normalized());
  return Quaterniond(AngleAxisd(std::atan2(across.norm(), along.z()), axis));
}

Quaterniond of_axis_angle(const XmlElement& element, const std::vector<double>& written, const Settings& settings) {
  const Vector3d axis(written[0], written[1], written[2]);
  if (axis.stableNorm() > kNoDirection)
    return Quaterniond(AngleAxisd(settings.angle(written[3]), axis.stableNormalized()));
  element.problem("axisangle's axis has no direction");
  return Quaterniond::Identity();
}

Quaterniond of_quaternion(const XmlElement& element, const std::vector<double>& written) {
  const Eigen::Vector4d turn(written[1], written[2], written[3], written[0]);  // x, y, z, w as Eigen keeps them
  if (turn.stableNorm() > kNoDirection) return Quaterniond(turn.stableNormalized());
  element.problem("quat has length 0; write 1 0 0 0 for no rotation");
  return Quaterniond::Identity();
}

Quaterniond orientation_of(const Attributes& source, const Settings& settings) {
  const XmlElement& element = source.element();
  Quaterniond turn = Quaterniond::Identity();
  int written = 0;
  if (const auto quat = source.numbers("quat", 4, 4); quat && ++written) turn = of_quaternion(element, *quat);
  if (const auto axis = source.numbers("axisangle", 4, 4); axis && ++written)
    turn = of_axis_angle(element, *axis, settings);
  if (const auto euler = source.numbers("euler", 3, 3); euler && ++written)
    turn = of_euler({(*euler)[0], (*euler)[1], (*euler)[2]}, settings);
  if (const auto axes = source.numbers("xyaxes", 6, 6); axes && ++written) turn = of_axes(element, *axes);
  if (const auto z = source.numbers("zaxis", 3, 3); z && ++written) turn = of_z(element, {(*z)[0], (*z)[1], (*z)[2]});
  if (written > 1) element.problem("has two orientations; keep one of quat, axisangle, euler, xyaxes, zaxis");
  return turn;
}

}  // namespace

double Settings::angle(double written) const { return degrees ? written * std::numbers::pi / 180.0 : written; }

Settings read_settings(const Document& document, std::vector<RobotRemark>& remarks) {
  Settings settings;
  for (const XmlElement& section : document.sections())
    if (section.name() == "compiler")
      read_compiler(section, settings);
    else if (section.name() == "option")
      read_option(document, section, settings, remarks);
  return settings;
}

Pose pose_of(const Attributes& source, const Settings& settings) {
  Pose pose;
  pose.position = source.vector("pos", Vector3d::Zero());
  const bool is_own = std::any_of(std::begin(kOrientations), std::end(kOrientations),
                                  [&](const char* attribute) { return source.says(attribute); });
  pose.orientation = orientation_of(is_own ? Attributes(source.element(), {}) : source, settings);
  return pose;
}

Pose pose_of(const XmlElement& element, const Settings& settings) { return pose_of(Attributes(element, {}), settings); }

}  // namespace lacuna::mjcf
