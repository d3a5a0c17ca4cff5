#include "oracle/linear_trial.h"

#include <memory>

namespace hidden_effects {
namespace {

constexpr double kStateChange = 1e-6, kReadingChange = 1e-6;

using Index = Eigen::Index;

/// A plant under a changed excitation, sample by sample.
class Flow {
 public:
  Flow(PlantSpec spec, const Laws& laws, Excitation excitation, double step)
      : excitation_(std::move(excitation)), plant_(std::move(spec), laws, excitation_, step) {}
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  PlantState after(PlantState state, std::size_t sample) {
    plant_.advance(state, sample, [](const PlantState&) {});
    return state;
  }
  const Simulation& plant() const { return plant_; }

 private:
  Excitation excitation_;
  Simulation plant_;
};

Excitation with_alternating_force(Excitation excitation, std::size_t joints, std::size_t joint, std::size_t parity,
                                  double size) {
  const std::size_t knots = excitation.samples() + 1;
  excitation.knot_interval = excitation.interval;
  excitation.forces.assign(joints, std::vector<double>(knots, 0.0));
  for (std::size_t k = parity; k < knots; k += 2) excitation.forces[joint][k] = size;
  return excitation;
}

PlantSpec with_offset(PlantSpec spec, std::size_t drive, double offset) {
  spec.drives[drive].offset += offset;
  return spec;
}

/// A change of either sign.
struct Pair {
  std::unique_ptr<Flow> more, less;
};

class Linearisation {
 public:
  Linearisation(PlantSpec spec, Laws laws, const TrueTrial& trial, double step)
      : spec_(std::move(spec)), laws_(std::move(laws)), trial_(trial), step_(step) {
    base_ = flow(spec_, trial.excitation);
    coordinates_ = base_->plant().coordinates();
    for (const auto& law : laws_) memory_ += law->memory_size();
  }

  LinearTrial run(const std::vector<double>& force_deviations, const std::vector<double>& command_deviations) {
    open_flows(force_deviations, command_deviations);
    LinearTrial linear{coordinates_, 2 * coordinates_ + memory_, {}, reading_gains()};
    PlantState state = base_->plant().start(trial_.start.position, trial_.start.velocity);
    for (std::size_t k = 0; k + 1 < trial_.excitation.samples(); ++k) {
      linear.samples.push_back({of_state(state, k), of_force(state, k, k % 2, force_deviations),
                                of_force(state, k, (k + 1) % 2, force_deviations),
                                of_command(state, k, command_deviations)});
      state = base_->after(state, k);
    }
    return linear;
  }

 private:
  std::unique_ptr<Flow> flow(const PlantSpec& spec, const Excitation& excitation) const {
    return std::make_unique<Flow>(spec, laws_, excitation, step_);
  }

  void open_flows(const std::vector<double>& forces, const std::vector<double>& commands) {
    const auto pushed = [&](std::size_t joint, std::size_t parity, double size) {
      return flow(spec_, with_alternating_force(trial_.excitation, spec_.joints.size(), joint, parity, size));
    };
    for (std::size_t parity = 0; parity < 2; ++parity)
      for (std::size_t j = 0; j < forces.size(); ++j)
        force_[parity].push_back({pushed(j, parity, forces[j]), pushed(j, parity, -forces[j])});
    for (std::size_t d = 0; d < commands.size(); ++d) {
      const PlantDrive& drive = base_->plant().spec().drives[d];
      const double offset = commands[d] * (drive.servo ? 1.0 : drive.gain);
      command_.push_back({flow(with_offset(spec_, d, offset), trial_.excitation),
                          flow(with_offset(spec_, d, -offset), trial_.excitation)});
    }
  }

  Eigen::VectorXd packed(const PlantState& state) const {
    Eigen::VectorXd all(2 * coordinates_ + memory_);
    all << state.position, state.velocity, Eigen::Map<const Eigen::VectorXd>(state.memory.data(), memory_);
    return all;
  }

  PlantState moved(PlantState state, Index i, double change) const {
    if (i < coordinates_)
      state.position[i] += change;
    else if (i < 2 * coordinates_)
      state.velocity[i - coordinates_] += change;
    else
      state.memory[static_cast<std::size_t>(i - 2 * coordinates_)] += change;
    return state;
  }

  Eigen::MatrixXd of_state(const PlantState& state, std::size_t k) {
    const Index states = 2 * coordinates_ + memory_;
    Eigen::MatrixXd table(states, states);
    for (Index i = 0; i < states; ++i)
      table.col(i) = (packed(base_->after(moved(state, i, kStateChange), k)) -
                      packed(base_->after(moved(state, i, -kStateChange), k))) /
                     (2.0 * kStateChange);
    return table;
  }

  Eigen::MatrixXd of_pairs(const PlantState& state, std::size_t k, std::vector<Pair>& pairs,
                           const std::vector<double>& sizes) const {
    Eigen::MatrixXd table = Eigen::MatrixXd::Zero(2 * coordinates_ + memory_, static_cast<Index>(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (sizes[i] > 0.0)
        table.col(static_cast<Index>(i)) =
            (packed(pairs[i].more->after(state, k)) - packed(pairs[i].less->after(state, k))) / (2.0 * sizes[i]);
    return table;
  }
  Eigen::MatrixXd of_force(const PlantState& state, std::size_t k, std::size_t parity,
                           const std::vector<double>& sizes) {
    return of_pairs(state, k, force_[parity], sizes);
  }
  Eigen::MatrixXd of_command(const PlantState& state, std::size_t k, const std::vector<double>& sizes) {
    return of_pairs(state, k, command_, sizes);
  }

  std::vector<std::vector<double>> reading_gains() {
    Motion motion = simulate_here();
    const auto before = read_sensors(spec_, laws_, motion);
    for (auto* of : {&motion.position, &motion.velocity})
      for (std::vector<double>& one : *of)
        for (double& value : one) value += kReadingChange;
    auto gains = read_sensors(spec_, laws_, motion);
    for (std::size_t s = 0; s < gains.size(); ++s)
      for (std::size_t k = 0; k < gains[s].size(); ++k) gains[s][k] = (gains[s][k] - before[s][k]) / kReadingChange;
    return gains;
  }

  Motion simulate_here() const {
    Simulation plant(spec_, laws_, trial_.excitation, step_);
    return simulate(plant, trial_.start, trial_.excitation.samples(), 1);
  }

  PlantSpec spec_;
  Laws laws_;
  const TrueTrial& trial_;
  double step_;
  int coordinates_ = 0, memory_ = 0;
  std::unique_ptr<Flow> base_;
  std::vector<Pair> force_[2], command_;  // of forces: at even and at odd samples
};

}  // namespace

LinearTrial linearised(const PlantModel& model, const Eigen::VectorXd& values, const TrueTrial& trial,
                       const std::vector<double>& force_deviations, const std::vector<double>& command_deviations,
                       double step) {
  return Linearisation(model.spec_at(values), model.laws_at(values), trial, step)
      .run(force_deviations, command_deviations);
}

}  // namespace hidden_effects
