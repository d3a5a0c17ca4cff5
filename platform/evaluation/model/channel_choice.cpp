#include "evaluation/model/channel_choice.h"

#include "foundation/address.h"

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

/// Gives a controller only a part of the readings. This part is kept at the end of its state, so that nothing is
/// allocated.
class PartialView : public Controller {
 public:
  PartialView(std::shared_ptr<const Controller> controller, std::vector<std::size_t> channels)
      : controller_(std::move(controller)), channels_(std::move(channels)) {}

  int state_size() const override { return controller_->state_size() + static_cast<int>(channels_.size()); }

  void act(double time, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override {
    const std::span<double> seen = state.last(channels_.size());
    for (std::size_t i = 0; i < channels_.size(); ++i) seen[i] = sensors[channels_[i]];
    controller_->act(time, seen, state.first(state.size() - channels_.size()), commands);
  }

 private:
  std::shared_ptr<const Controller> controller_;  // shared with the test's creator
  std::vector<std::size_t> channels_;
};

}  // namespace

std::vector<std::size_t> chosen_channels(const RobotSpec& robot, const std::vector<std::string>& patterns,
                                         const std::string& key, Complaints& complaints) {
  std::vector<std::size_t> chosen;
  if (patterns.empty()) return chosen;
  try {
    const ElementMatch match = match_elements(robot, patterns);
    if (match.kind != ElementKind::sensor) throw Error("only sensors can be read; name them as in \"sensor.angle*\"");
    std::size_t channel = 0;
    for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
      const std::size_t count = sensor_channels(robot, robot.sensors[i]).size();
      const bool wanted =
          std::find(match.elements.begin(), match.elements.end(), static_cast<int>(i)) != match.elements.end();
      for (std::size_t end = channel + count; channel < end; ++channel)
        if (wanted) chosen.push_back(channel);
    }
  } catch (const Error& error) {
    complaints.add(key, error);
  }
  return chosen;
}

Test with_view(Test test, const std::vector<std::size_t>& channels) {
  if (const auto* controller = std::get_if<std::shared_ptr<const Controller>>(&test.drive))
    test.drive = std::make_shared<const PartialView>(*controller, channels);
  return test;
}

Trial with_channels(Trial trial, const std::vector<std::string>& names) {
  TimeSeries kept;
  kept.times = trial.measured.times;
  kept.samples.resize(trial.measured.samples.rows(), trial.measured.samples.cols());
  std::vector<double> noise;
  for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
    const Channel& channel = trial.measured.channels[c];
    if (std::find(names.begin(), names.end(), channel.name) == names.end()) continue;
    kept.samples.col(static_cast<Eigen::Index>(kept.channels.size())) =
        trial.measured.samples.col(static_cast<Eigen::Index>(c));
    kept.channels.push_back(channel);
    if (c < trial.sensor_noise.size()) noise.push_back(trial.sensor_noise[c]);
  }
  if (kept.channels.empty())
    throw Error("trial " + trial.name + " has no readings of the sensors that estimation.sensors names");
  kept.samples.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(kept.channels.size()));
  trial.measured = std::move(kept);
  trial.sensor_noise = std::move(noise);
  return trial;
}

}  // namespace lacuna
