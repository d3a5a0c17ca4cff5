#include "mjcf_actuators.h"

#include <algorithm>
#include <cmath>

namespace lacuna::mjcf {
namespace {

const std::vector<std::string_view> kKinds = {"general", "motor", "position", "velocity", "intvelocity"};

/// The force is gain·u + bias + per_length·l + per_velocity·l', where l is the gear times the coordinate.
struct Law {
  double gain = 1.0, bias = 0.0, per_length = 0.0, per_velocity = 0.0;
};

class ActuatorReader {
 public:
  ActuatorReader(const Attributes& element, const std::vector<std::vector<double>>& inertias, File& file)
      : element_(element), inertias_(inertias), file_(file) {}

  std::optional<ActuatorSpec> read() {
    ActuatorSpec spec;
    spec.name = name();
    if (!find_joint()) return std::nullopt;
    spec.joint = joint_->name;
    const auto gears = element_.numbers("gear", 1, 6);
    gear_ = gears ? gears->front() : 1.0;
    if (gear_ == 0.0) {
      element_.element().problem("actuator's gear is 0, so it drives nothing");
      return std::nullopt;
    }
    const std::optional<Law> law = read_law();
    if (!law || !put(*law, spec)) return std::nullopt;
    limit(spec);
    return spec;
  }

 private:
  const XmlElement& xml() const { return element_.element(); }
  void leave_out(const std::string& what) {
    file_.remark(RobotRemarkKind::left_out, xml(), "actuator " + name_ + ": " + what);
  }

  std::string name() {
    const std::string written = xml().text_of("name").value_or("");
    name_ = written.empty() ? file_.names.new_name("actuator", "motor_" + std::to_string(xml().line()))
                            : file_.names.named("actuator", written, xml().line(), xml().file(), file_.remarks);
    return name_;
  }

  bool find_joint() {
    const auto in_parent = element_.text_of("jointinparent"), written = element_.text_of("joint");
    if (!in_parent && !written) {
      leave_out("it drives no joint");
      return false;
    }
    const auto found = file_.joint_of_name.find(in_parent ? *in_parent : *written);
    if (found == file_.joint_of_name.end()) {
      xml().problem("actuator " + name_ + " names the joint \"" + (in_parent ? *in_parent : *written) +
                    "\", which does not exist");
      return false;
    }
    place_ = found->second;
    joint_ = &file_.bodies[place_.first].joints[place_.second];
    if (joint_->kind == JointKind::hinge || joint_->kind == JointKind::slider) return true;
    leave_out("joint " + joint_->name + " has several coordinates");
    return false;
  }

  std::optional<Law> read_law() {
    const std::string_view kind = xml().name();
    if (kind == "motor") return Law{};
    if (kind == "velocity") {
      const double kv = element_.number("kv", 1.0);
      return Law{kv, 0.0, 0.0, -kv};
    }
    if (kind == "position") return position_law();
    if (kind == "general") return general_law();
    leave_out("<" + std::string(kind) + "> is not motor, position, velocity or general");
    return std::nullopt;
  }

  /// Filters have states.
  void note_filter(const std::string& dynamics) {
    if (dynamics != "none") leave_out("its filter of the command (" + dynamics + "); add actuator_lag for it");
  }

  std::optional<Law> position_law() {
    const double kp = element_.number("kp", 1.0);
    double kv = element_.number("kv", 0.0);
    const double ratio = element_.number("dampratio", 0.0);
    if (ratio > 0.0) kv = ratio * 2.0 * std::sqrt(std::max(kp, 0.0) * felt_inertia());
    if (element_.number("timeconst", 0.0) > 0.0) note_filter("timeconst");
    return Law{kp, 0.0, -kp, -kv};
  }

  /// At the actuator: inertia of the joint over the square of the gear.
  double felt_inertia() const { return inertias_[place_.first][place_.second] / (gear_ * gear_); }

  std::optional<Law> general_law() {
    note_filter(element_.text_of("dyntype").value_or("none"));
    const std::string gain_kind = element_.text_of("gaintype").value_or("fixed");
    const std::string bias_kind = element_.text_of("biastype").value_or("none");
    if (gain_kind != "fixed" || (bias_kind != "none" && bias_kind != "affine")) {
      leave_out("its gain (" + gain_kind + ") or bias (" + bias_kind + ") is not supported");
      return std::nullopt;
    }
    const std::vector<double> gain = element_.numbers("gainprm", 1, 10).value_or(std::vector<double>{1.0});
    Law law{gain.front(), 0.0, 0.0, 0.0};
    if (bias_kind == "none") return law;
    std::vector<double> bias = element_.numbers("biasprm", 1, 10).value_or(std::vector<double>{});
    bias.resize(3, 0.0);
    law.bias = bias[0];
    law.per_length = bias[1];
    law.per_velocity = bias[2];
    if (law.per_velocity > 0.0 && law.per_length < 0.0)  // a damping ratio, as in MuJoCo 3
      law.per_velocity = -law.per_velocity * 2.0 * std::sqrt(-law.per_length * felt_inertia());
    return law;
  }

  /// The law as a servo on the joint, with the coordinate counted from the reference.
  bool put(const Law& law, ActuatorSpec& spec) {
    const double at_joint = gear_ * gear_;
    if (law.per_length > 0.0 || law.per_velocity > 0.0) {
      leave_out("its force grows with position or velocity, unlike a servo's");
      return false;
    }
    if (law.per_length < 0.0) {
      spec.kind = ActuatorKind::position_servo;
      spec.kp = -law.per_length * at_joint;
      spec.kd = -law.per_velocity * at_joint;
      spec.gain = law.gain / -law.per_length / gear_;
      spec.offset = law.bias / -law.per_length / gear_ - joint_->reference;
    } else if (law.per_velocity < 0.0) {
      spec.kind = ActuatorKind::velocity_servo;
      spec.kd = -law.per_velocity * at_joint;
      spec.gain = law.gain / -law.per_velocity / gear_;
      spec.offset = law.bias / -law.per_velocity / gear_;
    } else {
      spec.gain = law.gain * gear_;
      spec.offset = law.bias * gear_;
    }
    return true;
  }

  std::optional<std::pair<double, double>> limits(const char* range_name, const char* flag_name) {
    const auto range = element_.numbers(range_name, 2, 2);
    if (!element_.flag(flag_name, range && file_.settings.auto_limits)) return std::nullopt;
    if (range && range->at(0) < range->at(1)) return std::pair(range->at(0), range->at(1));
    if (range && (range->at(0) != 0.0 || range->at(1) != 0.0))
      xml().problem(std::string("actuator's ") + range_name + ": the lower bound must be below the upper one");
    return std::nullopt;
  }

  void limit(ActuatorSpec& spec) {
    std::optional<std::pair<double, double>> commands = limits("ctrlrange", "ctrllimited");
    if (const double inherited = element_.number("inheritrange", 0.0);
        inherited > 0.0 && std::isfinite(joint_->lower) && spec.kind == ActuatorKind::position_servo) {
      const double middle = 0.5 * (joint_->lower + joint_->upper) + joint_->reference;
      const double half = 0.5 * inherited * (joint_->upper - joint_->lower);
      commands = {(middle - half) * gear_, (middle + half) * gear_};
    }
    if (commands) {
      const double a = spec.gain * commands->first + spec.offset, b = spec.gain * commands->second + spec.offset;
      spec.command_lower = std::min(a, b);
      spec.command_upper = std::max(a, b);
    }
    spec.force_limit = joint_->force_limit;
    if (const auto forces = limits("forcerange", "forcelimited")) {
      const double largest = std::max(std::abs(forces->first), std::abs(forces->second));
      if (forces->first != -forces->second)
        leave_out("its forcerange is not symmetrical; the larger bound is used for both");
      spec.force_limit = std::min(spec.force_limit, largest * std::abs(gear_));
    }
  }

  const Attributes& element_;
  const std::vector<std::vector<double>>& inertias_;
  File& file_;
  std::string name_;
  std::pair<std::size_t, std::size_t> place_;
  const Joint* joint_ = nullptr;
  double gear_ = 1.0;
};

}  // namespace

std::vector<ActuatorSpec> read_actuators(const Document& document, const DefaultClasses& classes,
                                         const std::vector<std::vector<double>>& inertias, File& file) {
  std::vector<ActuatorSpec> actuators;
  for (const XmlElement& element : document.sections("actuator")) {
    const Attributes attributes = classes.of(element, "", kKinds);
    if (std::optional<ActuatorSpec> spec = ActuatorReader(attributes, inertias, file).read())
      actuators.push_back(std::move(*spec));
  }
  return actuators;
}

}  // namespace lacuna::mjcf
