#include "evaluation/model/channel_map.h"

#include <lacuna/error.h>

#include "foundation/name_index.h"
#include "foundation/text/problem.h"

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
  const NameIndex known(model_channels, [](const Channel& channel) { return std::string_view(channel.name); });
  for (const Channel& channel : trial.measured.channels) {
    const std::optional<std::size_t> found = known.find(channel.name);
    if (!found)
      throw Error("trial " + trial.name + " measures \"" + channel.name +
                  "\", but the model has no sensor channel of that name" +
                  did_you_mean(channel.name, names_of(model_channels)) +
                  "; map the column to one of the robot's sensors");
    const std::string& unit = model_channels[*found].unit;
    if (unit != channel.unit)
      throw Error("trial " + trial.name + " measures \"" + channel.name + "\" in " + channel.unit +
                  ", the model's sensor reads " + unit + "; correct the unit of the column or the kind of the sensor");
    map.push_back(static_cast<Eigen::Index>(*found));
  }
  return map;
}

}  // namespace lacuna
