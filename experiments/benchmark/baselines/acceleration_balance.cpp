#include "baselines/acceleration_balance.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kStandstill = 0.02;  ///< of the largest velocity

/// The mean of a held command over a sample interval around `time`.
double command_around(const std::vector<double>& held, double time, double interval) {
  const double place = time / interval - 0.5, last = static_cast<double>(held.size() - 1);
  const auto at = [&](double k) { return held[static_cast<std::size_t>(std::clamp(k, 0.0, last))]; };
  const double first = std::floor(place), part = place - first;
  return (1.0 - part) * at(first) + part * at(first + 1.0);
}

class Balance {
 public:
  Balance(const PlantModel& model, const Eigen::VectorXd& values, const Excitation& excitation,
          const RecordedMotion& motion)
      : spec_(model.spec_at(values)),
        laws_(model.laws_at(values)),
        excitation_(excitation),
        motion_(motion),
        joints_(static_cast<Eigen::Index>(spec_.joints.size())),
        drive_(Coordinates::Zero(joints_)) {
    for (const auto& law : laws_) {
      law->amend(spec_);
      memory_of_law_.push_back(memory_.size());
      memory_.resize(memory_.size() + static_cast<std::size_t>(law->memory_size()));
    }
    for (const std::vector<double>& velocity : motion_.velocity) {
      double most = 0.0;
      for (const double v : velocity) most = std::max(most, std::abs(v));
      standstill_.push_back(std::max(kStandstill * most, 1e-12));
    }
  }

  bool is_rigid() const {
    return std::none_of(spec_.drives.begin(), spec_.drives.end(), [](const PlantDrive& d) { return d.elastic; });
  }

  Eigen::MatrixXd run() {
    const std::size_t samples = excitation_.samples();
    Eigen::MatrixXd balance(static_cast<Eigen::Index>(samples), joints_);
    for (std::size_t l = 0; l < laws_.size(); ++l)
      laws_[l]->start(at(motion_.position, 0), at(motion_.velocity, 0), memory_.data() + memory_of_law_[l]);
    Chain chain(spec_);
    for (std::size_t k = 0; k < samples; ++k) balance.row(static_cast<Eigen::Index>(k)) = at_sample(k, chain);
    return balance;
  }

 private:
  Coordinates at(const std::vector<std::vector<double>>& of_joints, std::size_t k) const {
    Coordinates values(joints_);
    for (Eigen::Index j = 0; j < joints_; ++j) values[j] = of_joints[static_cast<std::size_t>(j)][k];
    return values;
  }

  Coordinates at_sample(std::size_t k, Chain& chain) {
    const Coordinates q = at(motion_.position, k), v = at(motion_.velocity, k), a = at(motion_.acceleration, k);
    const double time = static_cast<double>(k) * excitation_.interval;
    const Moment moment{time, excitation_.interval, q, v, drive_, spec_, chain};
    chain.move_to(q, v);
    Load load{Coordinates::Zero(joints_), Coordinates::Zero(joints_), Coordinates::Zero(joints_)};
    CoordinateMatrix inertia = CoordinateMatrix::Zero(joints_, joints_);
    chain.add_inertia(inertia, load.force);
    add_drives(moment, inertia, load);
    for (Eigen::Index j = 0; j < joints_; ++j) {
      const PlantJoint& joint = spec_.joints[static_cast<std::size_t>(j)];
      inertia(j, j) += joint.armature;
      load.force[j] += joint.force - joint.damping * v[j] - joint.stiffness * (q[j] - joint.rest);
    }
    for (std::size_t l = 0; l < laws_.size(); ++l) laws_[l]->act(moment, memory_.data() + memory_of_law_[l], load);
    Coordinates left = load.force - inertia * a;
    for (Eigen::Index j = 0; j < joints_; ++j) {
      const double way = std::clamp(v[j] / standstill_[static_cast<std::size_t>(j)], -1.0, 1.0);
      left[j] -= way * (way > 0.0 ? load.brake_forwards[j] : load.brake_backwards[j]);
    }
    return inertia.inverse() * left;
  }

  void add_drives(const Moment& moment, CoordinateMatrix& inertia, Load& load) {
    drive_.setZero();
    for (std::size_t d = 0; d < spec_.drives.size(); ++d) {
      const PlantDrive& drive = spec_.drives[d];
      const int number = static_cast<int>(d);
      double late = drive.delay;
      for (const auto& law : laws_) late += law->lateness(number, moment.time);
      double value = command_around(excitation_.commands[d], moment.time - late, excitation_.interval);
      if (!drive.servo) value *= drive.gain;
      value += drive.offset;
      for (std::size_t l = 0; l < laws_.size(); ++l)
        value = laws_[l]->command(number, value, moment, memory_.data() + memory_of_law_[l]);
      if (drive.servo)
        value =
            drive.gain * (drive.kp * (value - moment.position[drive.joint]) - drive.kd * moment.velocity[drive.joint]);
      value = std::clamp(value, -drive.limit, drive.limit);
      drive_[drive.joint] += value;
      load.force[drive.joint] += value;
      inertia(drive.joint, drive.joint) += drive.rotor_inertia;
    }
  }

  PlantSpec spec_;
  Laws laws_;
  const Excitation& excitation_;
  const RecordedMotion& motion_;
  Eigen::Index joints_;
  Coordinates drive_;
  std::vector<double> memory_, standstill_;
  std::vector<std::size_t> memory_of_law_;
};

}  // namespace

Eigen::MatrixXd acceleration_balance(const PlantModel& model, const Eigen::VectorXd& values,
                                     const Excitation& excitation, const RecordedMotion& motion) {
  Balance balance(model, values, excitation, motion);
  return balance.is_rigid() ? balance.run() : Eigen::MatrixXd();
}

}  // namespace hidden_effects
