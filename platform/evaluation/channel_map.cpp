#include "evaluation/channel_map.h"

#include <lacuna/error.h>

#include "foundation/problem.h"

#include <algorithm>

namespace lacuna {
namespace {

std::vector<std::string> names_of(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  return names;
}

}  // namespace

std::vector<Eigen::Index> match_channels(const Trial& trial, const std::vector<Channel>& model_channels) {
  std::vector<Eigen::Index> map;
  for (const Channel& channel : trial.measured.channels) {
    const auto found = std::find_if(model_channels.begin(), model_channels.end(),
                                    [&](const Channel& candidate) { return candidate.name == channel.name; });
    if (found == model_channels.end())
      throw Error("trial " + trial.name + " measures \"" + channel.name +
                  "\", but the model has no sensor channel of that name" +
                  did_you_mean(channel.name, names_of(model_channels)) +
                  "; map the column to one of the robot's sensors");
    if (found->unit != channel.unit)
      throw Error("trial " + trial.name + " measures \"" + channel.name + "\" in " + channel.unit +
                  ", the model's sensor reads " + found->unit +
                  "; correct the unit of the column or the kind of the sensor");
    map.push_back(found - model_channels.begin());
  }
  return map;
}

}  // namespace lacuna
