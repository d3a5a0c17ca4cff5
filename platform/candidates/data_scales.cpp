#include "candidates/data_scales.h"

#include "foundation/statistics.h"
#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kSpan = 0.02;       // s, time over which positions are differentiated to a speed
constexpr double kRarely = 0.95;     // share of samples with a smaller speed
constexpr double kAnInterval = 1.5;  // times the interval between readings: the largest distance of neighbouring ones
constexpr double kFewestReadings = 4.0;  // readings per wave, at the usual speed
constexpr double kMostPhase = 100.0;  // rad, largest phase of a wave over the range of a channel, all channels together
constexpr double kMostOfATurn = 24.0;  // waves per turn, tried for an angle however far it turns
constexpr double kPhaseApart = 3.0;    // rad over the range, between the wave numbers that are tried

void hold(double& largest, double value) { largest = std::max(largest, value); }

double usual_interval(const Eigen::VectorXd& times) {
  return times.size() < 2 ? 0.0 : (times(times.size() - 1) - times(0)) / static_cast<double>(times.size() - 1);
}

double usual_speed(const Eigen::VectorXd& times, const Eigen::Ref<const Eigen::VectorXd>& values) {
  const double most_apart = std::max(kSpan, kAnInterval * usual_interval(times));
  std::vector<double> speeds;
  Eigen::Index behind = 0;
  for (Eigen::Index row = 0; row < values.size(); ++row) {
    while (times(row) - times(behind) > most_apart) ++behind;
    const double span = times(row) - times(behind);
    const double speed = std::abs(values(row) - values(behind)) / span;
    if (span > 0.0 && std::isfinite(speed)) speeds.push_back(speed);
  }
  if (speeds.empty()) return 0.0;
  return quantile_of(speeds, kRarely);
}

double known(const std::map<std::string, double>& scales, const std::string& unit) {
  const auto found = scales.find(unit);
  return found == scales.end() ? 0.0 : found->second;
}

/// Distance over which a speed carries the joint.
double way_of(const Eigen::VectorXd& times, const Eigen::Ref<const Eigen::VectorXd>& speeds) {
  double place = 0.0, least = 0.0, most = 0.0;
  for (Eigen::Index row = 1; row < speeds.size(); ++row) {
    const double step = 0.5 * (speeds(row) + speeds(row - 1)) * (times(row) - times(row - 1));
    if (std::isfinite(step)) place += step;
    least = std::min(least, place);
    most = std::max(most, place);
  }
  return most - least;
}

/// Wave numbers, rad per unit.
std::vector<double> waves_to_try(double range, double most, bool turns) {
  std::vector<double> waves;
  if (turns) waves = {1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, kMostOfATurn};
  if (range > 0.0)
    for (double wave = 2.0 * std::numbers::pi / range; wave <= kMostPhase / range; wave += kPhaseApart / range)
      waves.push_back(wave);
  std::erase_if(waves, [&](double wave) { return wave > most; });
  return waves;
}

bool is_speed(const std::string& unit) { return unit.ends_with("/s"); }

std::string unit_of_way(const std::string& unit) { return is_speed(unit) ? unit.substr(0, unit.size() - 2) : unit; }

/// Range and speed in one channel, and its largest resolved wave number, rad per unit: four readings per wave.
struct ChannelScales {
  double range = 0.0, speed = 0.0, wave = 0.0;
};

ChannelScales scales_of(const Trial& trial, std::size_t channel) {
  const Eigen::VectorXd& times = trial.measured.times;
  const Eigen::VectorXd values = trial.measured.samples.col(static_cast<Eigen::Index>(channel));
  double low = INFINITY, high = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  ChannelScales scales;
  if (!(high > low)) return scales;
  scales.range = high - low;
  scales.speed = usual_speed(times, values);
  const double moves = is_speed(trial.measured.channels[channel].unit) ? std::max(-low, high) : scales.speed;
  if (moves > 0.0) scales.wave = 2.0 * std::numbers::pi / (kFewestReadings * moves * usual_interval(times));
  return scales;
}

std::size_t channels_of(const Trial& trial, const std::string& unit) {
  return static_cast<std::size_t>(std::count_if(trial.measured.channels.begin(), trial.measured.channels.end(),
                                                [&](const Channel& channel) { return channel.unit == unit; }));
}

/// Limits the number of waves over all channels to what a search can try.
void bound_waves(const std::map<std::string, std::size_t>& channels, std::map<std::string, double>& scales) {
  for (const auto& [unit, count] : channels) {
    const auto wave = scales.find("1/" + unit);
    if (wave == scales.end() || !(known(scales, unit) > 0.0)) continue;
    const double most = kMostPhase / (known(scales, unit) * static_cast<double>(count));
    wave->second = std::min(wave->second, unit == "rad" ? std::max(most, kMostOfATurn) : most);
  }
}

}  // namespace

std::map<std::string, double> data_scales(const std::vector<Trial>& trials) {
  std::map<std::string, double> scales;
  std::map<std::string, std::size_t> channels;  // channels that measure this unit
  for (const Trial& trial : trials)
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
      const std::string& unit = trial.measured.channels[c].unit;
      const std::string of_way = unit_of_way(unit);
      const ChannelScales own = scales_of(trial, c);
      if (own.range > 0.0) hold(scales[unit], own.range);
      hold(scales[unit + "/s"], own.speed);
      if (own.wave > 0.0) hold(scales["1/" + of_way], own.wave);
      if (is_speed(unit) && channels_of(trial, of_way) == 0)
        hold(scales[of_way], way_of(trial.measured.times, trial.measured.samples.col(static_cast<Eigen::Index>(c))));
      channels[of_way] = std::max(channels[of_way], channels_of(trial, unit));
    }
  bound_waves(channels, scales);
  return scales;
}

std::vector<double> shapes_to_try(const std::string& unit, const std::map<std::string, double>& scales) {
  if (unit == "1/s") return {10.0, 60.0, 300.0};
  if (unit == "s") return {1.0, 10.0};
  if (unit.starts_with("1/")) return waves_to_try(known(scales, unit.substr(2)), known(scales, unit), unit == "1/rad");
  const double usual = known(scales, unit);
  if (!(usual > 0.0)) return {};
  const bool speed = unit.size() > 2 && unit.ends_with("/s");
  return speed ? std::vector{0.02 * usual, 0.2 * usual} : std::vector{0.03 * usual, 0.3 * usual};
}

void bound_by_resolution(const std::vector<EffectEntry>& added, const std::map<std::string, double>& scales,
                         std::vector<FreeValue>& free) {
  for (FreeValue& value : free) {
    if (!value.unit.starts_with("1/") || value.scale != Scale::logarithmic) continue;
    if (std::none_of(added.begin(), added.end(),
                     [&](const EffectEntry& entry) { return is_of_effect(value.address, entry.id); }))
      continue;
    const double most = known(scales, value.unit), range = known(scales, value.unit.substr(2));
    if (!(most > 0.0) || !(range > 0.0)) continue;
    const double least = value.unit == "1/rad" ? 1.0 : 2.0 * std::numbers::pi / range;
    value.lower = std::clamp(least, value.lower, value.upper);
    value.upper = std::clamp(std::max(most, least), value.lower, value.upper);
    value.start = std::clamp(value.start, value.lower, value.upper);
  }
}

}  // namespace lacuna
