#include "dirty/recording.h"

#include <algorithm>
#include <cmath>

namespace hidden_effects::dirty {
namespace {

/// Between two dense readings along a straight line.
double at_time(const DenseReadings& dense, double time) {
  const double last = static_cast<double>(dense.values.size() - 1);
  const double place = std::clamp(time / dense.interval, 0.0, last);
  const auto k = std::min(static_cast<std::size_t>(place), dense.values.size() - 2);
  const double part = place - static_cast<double>(k);
  return (1.0 - part) * dense.values[k] + part * dense.values[k + 1];
}

/// A sensor with its noise, read at times that go on.
class NoisySensor {
 public:
  NoisySensor(const DenseReadings& dense, const Recording& recording, std::size_t sensor, double interval,
              std::uint64_t seed)
      : dense_(dense),
        white_(recording.white[sensor]),
        quantum_(recording.quantum[sensor]),
        normal_(mixed(seed, 200 + sensor)),
        lasting_(recording.lasting[sensor], recording.lasting_time, interval, mixed(seed, 300 + sensor)) {}

  double read(double time) {
    double value = at_time(dense_, time) + white_ * normal_() + lasting_.value();
    lasting_.next();
    if (quantum_ > 0.0) value = bench::rounded(value, quantum_);
    return value;
  }

 private:
  const DenseReadings& dense_;
  double white_, quantum_;
  bench::Normal normal_;
  bench::Disturbance lasting_;
};

/// When samples are taken and what their stamps say.
struct Stamps {
  std::vector<double> taken, said;  ///< s
  std::vector<bool> dropped;
};

Stamps draw_stamps(std::size_t samples, double interval, const Recording& recording, std::uint64_t seed) {
  RigDraw draw(seed, 500);
  Stamps stamps;
  double last = -1e9;
  for (std::size_t k = 0; k < samples; ++k) {
    const double late = recording.jitter * draw.uniform(), waited = -std::log(1.0 - draw.uniform());
    const double taken = (static_cast<double>(k) + late) * interval;
    double said = taken + std::min(0.9, recording.receipt * waited) * interval;
    said = std::max(said, last + 0.05 * interval);
    last = said;
    stamps.taken.push_back(taken);
    stamps.said.push_back(said);
    const bool inside = k > 1 && k + 2 < samples;
    stamps.dropped.push_back(inside && draw.chance(recording.drops));
  }
  return stamps;
}

/// What the owner logs as the command of a drive at a sample.
double logged_command(const DirtyRig& rig, const TrueTrial& trial, const TrialPlan& plan, std::size_t d,
                      std::size_t k) {
  return rig.driving == Driving::imposed ? plan.reference[d][k] : trial.applied.commands[d][k];
}

Table of_second_device(const std::string& name, NoisySensor sensor, double duration, const Recording& recording) {
  Table table{{"t", name}, {}};
  const double shift = 0.37 * recording.second_interval;
  for (double time = shift; time < duration; time += recording.second_interval)
    table.rows.push_back({time - recording.second_offset, sensor.read(time)});
  return table;
}

}  // namespace

Recording draw_recording(const DirtyRig& rig, const std::vector<double>& range, const std::vector<double>& speed,
                         std::uint64_t seed) {
  RigDraw draw(seed, 20);
  Recording recording;
  const bool lasts = draw.chance(0.5), coarse = draw.chance(0.5);
  const double lasting = draw.between(0.4, 1.5), quantum = draw.between(0.5, 4.0);
  recording.lasting_time = draw.log_between(0.05, 2.0);
  const bool uneven = draw.chance(0.4);
  recording.jitter = uneven ? draw.between(0.02, 0.3) : 0.0;
  recording.receipt = draw.chance(0.3) ? draw.between(0.02, 0.25) : 0.0;
  recording.drops = draw.chance(0.25) ? draw.log_between(0.002, 0.05) : 0.0;
  recording.declares_noise = draw.chance(0.3);
  recording.declares_quantum = coarse && draw.chance(0.5);
  const double force_noise = draw.log_between(0.01, 0.05);
  for (std::size_t s = 0; s < rig.stated.sensors.size(); ++s) {
    const bool is_force = rig.driving == Driving::imposed && s == 1;
    const double white = range[s] * (is_force ? force_noise : rig.noise * draw.between(0.8, 1.25));
    recording.white.push_back(white);
    recording.lasting.push_back(lasts ? lasting * white : 0.0);
    recording.quantum.push_back(coarse ? quantum * white : 0.0);
  }
  // Stamps may not spoil readings beyond all else.
  double worst = 0.0;
  for (std::size_t s = 0; s < speed.size(); ++s)
    worst = std::max(worst, recording.receipt * rig.interval * speed[s] / (3.0 * recording.white[s]));
  if (worst > 1.0) recording.receipt /= worst;
  const bool one_joint = rig.stated.sensors.size() == 1;
  recording.two_devices = one_joint && rig.driving != Driving::none && draw.chance(0.15);
  recording.second_offset = draw.between(-0.4, 0.4);
  recording.second_interval = rig.interval * draw.log_between(1.1, 3.0);
  recording.time_unit = draw.chance(0.3) ? "ms" : "s";
  recording.angle_unit = draw.chance(0.4) ? "deg" : "rad";
  recording.length_unit = draw.chance(0.4) ? "mm" : "m";
  const bool by_force = rig.driving == Driving::open_loop || rig.driving == Driving::position_loop;
  if (by_force && draw.chance(0.3)) recording.amperes = draw.log_between(0.02, 5.0);
  return recording;
}

std::vector<double> reading_noise(const Recording& recording, const DirtyRig& rig, const std::vector<double>& speed) {
  std::vector<double> noise;
  for (std::size_t s = 0; s < recording.white.size(); ++s) {
    const double stamps = recording.receipt * rig.interval * speed[s];
    noise.push_back(std::sqrt(recording.white[s] * recording.white[s] + recording.lasting[s] * recording.lasting[s] +
                              recording.quantum[s] * recording.quantum[s] / 12.0 + stamps * stamps));
  }
  return noise;
}

RecordedTrial record(const DirtyRig& rig, const Truth& truth, const TrueTrial& trial, const TrialPlan& plan,
                     const Recording& recording, std::uint64_t seed) {
  const std::size_t first = recording.two_devices ? 1 : 0;
  RecordedTrial done{plan.name, plan.held_out, {{"t"}, {}}, {}};
  std::vector<DenseReadings> dense;
  std::vector<NoisySensor> sensors;
  for (std::size_t s = 0; s < rig.stated.sensors.size(); ++s)
    dense.push_back(read_densely(truth.spec, truth.laws, trial, s));
  for (std::size_t s = 0; s < dense.size(); ++s) {
    const bool second = recording.two_devices && s == 0;
    sensors.emplace_back(dense[s], recording, s, second ? recording.second_interval : rig.interval, seed);
  }
  for (const PlantDrive& drive : rig.stated.drives) done.table.columns.push_back(drive.name);
  const std::size_t wanted = recording.logs_reference ? rig.loops.size() : 0;
  for (std::size_t s = first; s < dense.size(); ++s) done.table.columns.push_back(rig.stated.sensors[s].name);
  for (std::size_t d = 0; d < wanted; ++d) done.table.columns.push_back("wanted_" + rig.stated.drives[d].name);
  const Stamps stamps = draw_stamps(plan.samples, rig.interval, recording, seed);
  for (std::size_t k = 0; k < plan.samples; ++k) {
    std::vector<double> row = {stamps.said[k]};
    for (std::size_t d = 0; d < rig.stated.drives.size(); ++d)
      row.push_back(rig.driving == Driving::imposed ? sensors[0].read(stamps.taken[k])
                                                    : logged_command(rig, trial, plan, d, k));
    for (std::size_t s = first; s < dense.size(); ++s)
      row.push_back(rig.driving == Driving::imposed && s == 0 ? row[1] : sensors[s].read(stamps.taken[k]));
    for (std::size_t d = 0; d < wanted; ++d) row.push_back(plan.reference[d][k]);
    if (!stamps.dropped[k]) done.table.rows.push_back(std::move(row));
  }
  if (recording.two_devices)
    done.second = of_second_device(rig.stated.sensors[0].name, sensors[0],
                                   static_cast<double>(plan.samples - 1) * rig.interval, recording);
  return done;
}

}  // namespace hidden_effects::dirty
