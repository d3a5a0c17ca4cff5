#include "dirty/owner_error.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace hidden_effects::dirty {
namespace {

constexpr double kFloor = 0.01;      ///< of the noise: what no error is below
constexpr double kMostError = 1e5;   ///< of the noise: what runs away counts as this
constexpr std::size_t kPoints = 10;  ///< of a segment that are compared
constexpr std::size_t kLengths = 3, kShortest = 10;

double rms_of(const std::vector<double>& squares) {
  double sum = 0.0;
  for (const double square : squares) sum += std::log(square + kFloor * kFloor);
  return std::exp(0.5 * sum / static_cast<double>(squares.size()));
}

/// The slope of dense readings at one of them.
double slope_at(const DenseReadings& dense, std::size_t k) {
  const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k + 1, dense.values.size() - 1);
  return (dense.values[after] - dense.values[before]) / (dense.interval * static_cast<double>(after - before));
}

/// Whether a sensor says what the joint does, just here and from step to step.
bool shows_motion(const DenseReadings& dense, const PlantSensor& sensor, const Motion& motion, std::size_t k) {
  const std::vector<double>& position = motion.position[static_cast<std::size_t>(sensor.joint)];
  const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k + 1, dense.values.size() - 1);
  return dense.values[before] == sensor.scale * position[before] && dense.values[k] == sensor.scale * position[k] &&
         dense.values[after] == sensor.scale * position[after];
}

std::size_t compared(std::size_t length) { return std::min(length, kPoints); }

}  // namespace

OwnerError::OwnerError(const DirtyRig& rig, const Truth& truth, const std::vector<TrueTrial>& trials,
                       const std::vector<double>& noise, const Effort& effort)
    : rig_(rig), truth_(truth), trials_(trials), noise_(noise), effort_(effort) {
  if (rig.driving != Driving::imposed) choose_segments(effort.most_steps);
}

void OwnerError::choose_segments(double most_steps) {
  std::size_t fewest = trials_.front().states.size(), used = 0;
  for (std::size_t t = 0; t < trials_.size(); ++t)
    if (!rig_.trials[t].held_out) fewest = std::min(fewest, trials_[t].states.size()), ++used;
  const auto longest = std::clamp(static_cast<std::size_t>(rig_.longest / rig_.interval), kShortest, fewest - 2);
  const std::size_t shortest = std::min(longest, std::max(kShortest, longest / 16));
  const double joints = static_cast<double>(rig_.stated.joints.size());
  const double samples = most_steps / joints / steps_a_sample(rig_, 1) / static_cast<double>(used);
  const auto least = static_cast<double>(shortest);
  blocks_ = longest == shortest ? 1 : kLengths;
  for (std::size_t block = 0; block < blocks_; ++block) {
    const double part = blocks_ == 1 ? 1.0 : static_cast<double>(block) / (kLengths - 1);
    const auto length =
        static_cast<std::size_t>(std::lround(least * std::pow(static_cast<double>(longest) / least, part)));
    for (std::size_t t = 0; t < trials_.size(); ++t) {
      if (rig_.trials[t].held_out) continue;
      const std::size_t room = trials_[t].states.size() - 1;
      const auto affordable = static_cast<std::size_t>(samples / static_cast<double>(length));
      const std::size_t count = std::clamp<std::size_t>(affordable, 2, std::max<std::size_t>(room / length, 1));
      for (std::size_t s = 0; s < count; ++s)
        segments_.push_back({t, count == 1 ? 0 : s * (room - length) / (count - 1), length, block});
    }
  }
  for (const Segment& one : segments_)
    block_of_row_.insert(block_of_row_.end(), compared(one.length) * rig_.stated.sensors.size(), one.block);
}

PlantSpec OwnerError::at_values(PlantSpec spec, const Eigen::VectorXd& values) const {
  for (std::size_t i = 0; i < rig_.free.size(); ++i)
    rig_.free[i].value.in(spec) = values[static_cast<Eigen::Index>(i)] * rig_.free[i].value.in(rig_.stated);
  return spec;
}

/// Where noise-free readings say that the rig is; what a model's laws remember is the truth's.
PlantState OwnerError::start(const Simulation& plant, const OwnerModel& model, const DenseData& data,
                             const Segment& at) const {
  const TrueTrial& trial = trials_[at.trial];
  const PlantState& really = trial.states[at.begin];
  const auto joints = static_cast<Eigen::Index>(model.spec.joints.size());
  Coordinates position = really.position.head(joints), velocity = really.velocity.head(joints);
  const std::size_t k = at.begin * readings_a_sample(trial);
  for (std::size_t s = 0; s < model.spec.sensors.size(); ++s) {
    const PlantSensor& sensor = model.spec.sensors[s];
    const DenseReadings& dense = data[at.trial][s];
    if (sensor.velocity) {
      velocity[sensor.joint] = dense.values[k] / sensor.scale;
      continue;
    }
    const double shown = dense.values[k] / sensor.scale;
    if (shows_motion(dense, sensor, trial.motion, k)) continue;  // a difference would only lose digits
    position[sensor.joint] = shown;
    velocity[sensor.joint] = slope_at(dense, k) / sensor.scale;
  }
  PlantState state = plant.start(position, velocity);
  if (plant.coordinates() == really.position.size() && plant.coordinates() > joints) {
    const Eigen::Index rotors = plant.coordinates() - joints;
    state.position.tail(rotors) = really.position.tail(rotors);
    state.velocity.tail(rotors) = really.velocity.tail(rotors);
  }
  state.acceleration = really.acceleration.head(std::min<Eigen::Index>(really.acceleration.size(), joints));
  state.acceleration.conservativeResize(plant.coordinates());
  if (plant.coordinates() > joints) state.acceleration.tail(plant.coordinates() - joints).setZero();
  std::size_t own = 0;
  for (std::size_t l = 0; l < model.laws.size(); ++l) {
    std::size_t there = 0;
    for (std::size_t i = 0; i < model.of_truth[l]; ++i)
      there += static_cast<std::size_t>(truth_.laws[i]->memory_size());
    for (int m = 0; m < model.laws[l]->memory_size(); ++m) state.memory[own++] = really.memory[there++];
  }
  return state;
}

Eigen::VectorXd OwnerError::imposed_residuals(const PlantSpec& spec, const OwnerModel& model,
                                              const DenseData& data) const {
  std::vector<double> all;
  for (std::size_t t = 0; t < trials_.size(); ++t) {
    if (rig_.trials[t].held_out) continue;
    const std::vector<double> force = force_needed(spec, model.laws, trials_[t].motion.position[0], rig_.interval);
    for (std::size_t k = 0; k < force.size(); ++k) all.push_back((data[t][1].values[k] - force[k]) / noise_[1]);
  }
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::VectorXd OwnerError::residuals(const OwnerModel& model, const DenseData& data,
                                      const Eigen::VectorXd& values) const {
  const PlantSpec spec = at_values(model.spec, values);
  if (rig_.driving == Driving::imposed) return imposed_residuals(spec, model, data);
  Eigen::VectorXd all(static_cast<Eigen::Index>(block_of_row_.size()));
  Eigen::Index row = 0;
  const double step = rig_.interval / steps_a_sample(rig_, model.finer);
  std::vector<std::unique_ptr<Simulation>> plants;
  for (const TrueTrial& trial : trials_)
    plants.push_back(std::make_unique<Simulation>(spec, model.laws, trial.applied, step));
  for (const Segment& at : segments_) {
    Simulation& plant = *plants[at.trial];
    PlantState state = start(plant, model, data, at);
    const std::size_t points = compared(at.length), stride = readings_a_sample(trials_[at.trial]);
    std::size_t next = 1;
    for (std::size_t k = 1; k <= at.length; ++k) {
      plant.advance(state, at.begin + k - 1, [](const PlantState&) {});
      if (k < next * at.length / points) continue;
      ++next;
      for (std::size_t s = 0; s < spec.sensors.size(); ++s) {
        const PlantSensor& sensor = spec.sensors[s];
        const double told = sensor.scale * (sensor.velocity ? state.velocity : state.position)[sensor.joint];
        const double error = (data[at.trial][s].values[(at.begin + k) * stride] - told) / noise_[s];
        all[row++] = std::isfinite(error) ? std::clamp(error, -kMostError, kMostError) : kMostError;
      }
    }
  }
  return all;
}

std::vector<double> OwnerError::mean_squares(const Eigen::VectorXd& residuals) const {
  if (block_of_row_.empty()) return {residuals.squaredNorm() / static_cast<double>(residuals.size())};
  std::vector<double> sums(blocks_, 0.0), counts(blocks_, 0.0);
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    const std::size_t block = block_of_row_[static_cast<std::size_t>(i)];
    sums[block] += residuals[i] * residuals[i];
    counts[block] += 1.0;
  }
  for (std::size_t b = 0; b < blocks_; ++b) sums[b] /= counts[b];
  return sums;
}

double OwnerError::told(const std::vector<double>& squares) const {
  if (!effort_.worst) return rms_of(squares);
  return std::max(kFloor, std::sqrt(*std::max_element(squares.begin(), squares.end())));
}

Eigen::VectorXd OwnerError::true_values() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(rig_.free.size()));
  for (std::size_t i = 0; i < rig_.free.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = rig_.free[i].value.in(truth_.spec) / rig_.free[i].value.in(rig_.stated);
  return values;
}

double OwnerError::unfitted(const OwnerModel& model, const DenseData& data) const {
  return told(mean_squares(residuals(model, data, true_values())));
}

/// The residuals' changes by each free value.
Eigen::MatrixXd OwnerError::slopes(const OwnerModel& model, const DenseData& data, const Eigen::VectorXd& values,
                                   const Eigen::VectorXd& left) const {
  constexpr double kStep = 1e-4;  // of a value
  Eigen::MatrixXd slopes(left.size(), values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    Eigen::VectorXd moved = values;
    moved[i] += kStep;
    slopes.col(i) = (residuals(model, data, moved) - left) / kStep;
  }
  return slopes;
}

/// Of Gauss-Newton on the sum of logarithms: each length's squares weigh by what is left of them.
Eigen::VectorXd OwnerError::step(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& left) const {
  const std::vector<double> squares = mean_squares(left);
  Eigen::VectorXd weight(left.size());
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    const std::size_t block = block_of_row_.empty() ? 0 : block_of_row_[static_cast<std::size_t>(i)];
    weight[i] = 1.0 / (squares[block] + kFloor * kFloor);
  }
  Eigen::MatrixXd normal = slopes.transpose() * weight.asDiagonal() * slopes;
  for (Eigen::Index i = 0; i < normal.rows(); ++i) normal(i, i) = normal(i, i) * (1.0 + 1e-6) + 1e-12;
  return -normal.ldlt().solve(slopes.transpose() * weight.asDiagonal() * left);
}

double OwnerError::of(const OwnerModel& model, const DenseData& data) const {
  Eigen::VectorXd values = true_values();
  Eigen::VectorXd left = residuals(model, data, values);
  double best = rms_of(mean_squares(left));
  for (int refit = 0; refit < effort_.most_refits && values.size() > 0; ++refit) {
    const Eigen::VectorXd way = step(slopes(model, data, values, left), left);
    const double before = best;
    for (double part = 1.0; part > 0.05 && best == before; part *= 0.4) {
      const Eigen::VectorXd tried = within_bounds(values + part * way);
      Eigen::VectorXd now = residuals(model, data, tried);
      const double error = rms_of(mean_squares(now));
      if (!(error < best)) continue;
      best = error;
      values = tried;
      left = std::move(now);
    }
    if (best > 0.99 * before) break;
  }
  return told(mean_squares(left));
}

Eigen::VectorXd OwnerError::within_bounds(Eigen::VectorXd values) const {
  for (std::size_t i = 0; i < rig_.free.size(); ++i) {
    double& value = values[static_cast<Eigen::Index>(i)];
    value = std::clamp(value, rig_.free[i].lower, rig_.free[i].upper);
  }
  return values;
}

DenseData clean_readings(const Truth& truth, const std::vector<TrueTrial>& trials, const Law* without) {
  Laws laws;
  for (const auto& law : truth.laws)
    if (law.get() != without) laws.push_back(law);
  DenseData data;
  for (const TrueTrial& trial : trials) {
    data.emplace_back();
    for (std::size_t s = 0; s < truth.spec.sensors.size(); ++s)
      data.back().push_back(read_densely(truth.spec, laws, trial, s));
  }
  return data;
}

}  // namespace hidden_effects::dirty
